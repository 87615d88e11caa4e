// libmatio, loaded when the first file of MATLAB is asked for: it brings HDF5, OpenSSL and thirty other libraries
// along, which would double what the system loads before main() of every one of our programs. Nothing else calls it.
#pragma once

#include <matio.h>

namespace session {

/// What of libmatio is called here, under its own names.
struct MatLibrary {
    decltype(&::Mat_CreateVer) createVer = nullptr;
    decltype(&::Mat_Open) open = nullptr;
    decltype(&::Mat_Close) close = nullptr;
    decltype(&::Mat_VarCreate) varCreate = nullptr;
    decltype(&::Mat_VarCreateStruct2) varCreateStruct = nullptr;
    decltype(&::Mat_VarFree) varFree = nullptr;
    decltype(&::Mat_VarGetStructFieldByName) varGetField = nullptr;
    decltype(&::Mat_VarRead) varRead = nullptr;
    decltype(&::Mat_VarSetStructFieldByName) varSetField = nullptr;
    decltype(&::Mat_VarWrite) varWrite = nullptr;
};

/// The same for as long as the program runs; nullptr where it is not installed. Any thread may ask.
const MatLibrary *matLibrary();

} // namespace session
