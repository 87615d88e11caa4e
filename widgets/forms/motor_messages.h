// What core says of motors as enums and keys, in the user's language: names of figures, what is wrong with a motor or
// with a file and what to do about it.
#pragma once

#include "drive/motor_view.h"
#include "motor/sheet.h"
#include "session/files/motor_file.h"

#include <QString>

namespace widgets {

struct FieldText {
    QString name, help;
};
/// Of a member of a structure; its own key where this program knows no better.
FieldText fieldText(const std::string &key);
/// Of a structure as a whole.
QString structureText(drive::StructureView::Of what);

QString motorQuantityText(motor::MotorQuantity quantity);
/// What is wrong, and what to do.
QString motorWarningText(motor::MotorWarning warning);

/// One sentence without the file's name.
QString motorFileErrorText(const session::MotorFileError &error);
QString motorFileNoteText(session::MotorFile::Note note);

} // namespace widgets
