// Boxes that ignore the mouse wheel until they have the keyboard focus.
#pragma once

class QWidget;

namespace elsie::desktop {

/// Lets the wheel change the box only while the box has the keyboard focus, which the wheel does
/// not give it. Otherwise the wheel moves the page that contains the box (QGIS#4245).
void quiet_wheel(QWidget* box);

}  // namespace elsie::desktop
