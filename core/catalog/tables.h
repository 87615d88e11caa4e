// The register tables of resources/registers, built into the library so that core needs no file
// access.
#pragma once

#include <string_view>

namespace catalog {

/// The CSV text of `resources/registers/<name>.csv`, or an empty view if there is none.
std::string_view builtInTable(std::string_view name);

} // namespace catalog
