// Files and disks for tests of saving.
#pragma once

#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QStandardPaths>

#include "../support/full_disk.h"
#include "window.h"

namespace elsie::desktop {

inline void write(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write(bytes);
}

using test::FullDisk;

inline QDir kept_work() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery");
}

inline void press_yes(QDialog* box) {
  QTest::mouseClick(qobject_cast<QMessageBox*>(box)->button(QMessageBox::Yes), Qt::LeftButton);
}
inline void press_no(QDialog* box) {
  QTest::mouseClick(qobject_cast<QMessageBox*>(box)->button(QMessageBox::No), Qt::LeftButton);
}

}  // namespace elsie::desktop
