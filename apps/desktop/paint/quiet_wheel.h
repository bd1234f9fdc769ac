// Boxes that the mouse wheel passes over.
#pragma once

class QWidget;

namespace elsie::desktop {

/// From now on the wheel changes the box only while it has the keyboard focus, and does not give it
/// that; otherwise it moves the page on which the box is (QGIS#4245).
void quiet_wheel(QWidget* box);

}  // namespace elsie::desktop
