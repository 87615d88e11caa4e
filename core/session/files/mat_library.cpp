#include "session/files/mat_library.h"

#include <QLibrary>

#include <optional>

namespace session {
namespace {

std::optional<MatLibrary> load()
{
    QLibrary file;
#ifdef ROTORSCOPE_MATIO_ABI // other versions have other structures
    file.setFileNameAndVersion(QStringLiteral("matio"), ROTORSCOPE_MATIO_ABI);
#else
    file.setFileName(QStringLiteral("matio"));
#endif
    MatLibrary library;
    bool whole = true;
    const auto find = [&](auto &function, const char *name) {
        function = reinterpret_cast<std::decay_t<decltype(function)>>(file.resolve(name));
        whole = whole && function != nullptr;
    };
    find(library.createVer, "Mat_CreateVer");
    find(library.open, "Mat_Open");
    find(library.close, "Mat_Close");
    find(library.varCreate, "Mat_VarCreate");
    find(library.varCreateStruct, "Mat_VarCreateStruct2");
    find(library.varFree, "Mat_VarFree");
    find(library.varGetField, "Mat_VarGetStructFieldByName");
    find(library.varRead, "Mat_VarRead");
    find(library.varSetField, "Mat_VarSetStructFieldByName");
    find(library.varWrite, "Mat_VarWrite");
    return whole ? std::optional(library) : std::nullopt;
}

} // namespace

const MatLibrary *matLibrary()
{
    static const std::optional<MatLibrary> library = load();
    return library ? &*library : nullptr;
}

} // namespace session
