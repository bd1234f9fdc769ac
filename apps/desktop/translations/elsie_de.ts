<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Dialogs</name>
    <message>
        <source>%1 x %2</source>
        <translation>%1 x %2</translation>
    </message>
    <message>
        <source>Export the film</source>
        <translation>Film exportieren</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>MP4 (H.264): for mails, slides and browsers</source>
        <translation>MP4 (H.264): für E-Mails, Folien und Browser</translation>
    </message>
    <message>
        <source>WebM (VP9): small, for browsers</source>
        <translation>WebM (VP9): klein, für Browser</translation>
    </message>
    <message>
        <source>GIF: plays everywhere, large, without a pause</source>
        <translation>GIF: läuft überall, groß, lässt sich nicht anhalten</translation>
    </message>
    <message>
        <source>AVI (Motion JPEG): large, needs no other program</source>
        <translation>AVI (Motion JPEG): groß, braucht kein anderes Programm</translation>
    </message>
    <message>
        <source>MP4, WebM and GIF need the program ffmpeg, which is not installed. &apos;sudo apt install ffmpeg&apos; installs it; then open this again.</source>
        <translation>MP4, WebM und GIF brauchen das Programm ffmpeg, das nicht installiert ist. &apos;sudo apt install ffmpeg&apos; installiert es; öffnen Sie dies dann noch einmal.</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>%1, as the view</source>
        <translation>%1, wie die Ansicht</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>&amp;Tempo</translation>
    </message>
    <message>
        <source>%1x: a film of %2 s</source>
        <translation>%1x: ein Film von %2 s</translation>
    </message>
    <message>
        <source>Export the picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>The &amp;view, as it is shown</source>
        <translation>Die &amp;Ansicht, wie sie gezeigt wird</translation>
    </message>
    <message>
        <source>From &amp;above, drawn: with paths, axes and a legend</source>
        <translation>Von &amp;oben, gezeichnet: mit Bahnen, Achsen und Legende</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>&amp;Width in print</source>
        <translation>&amp;Breite im Druck</translation>
    </message>
    <message>
        <source>&amp;Resolution</source>
        <translation>A&amp;uflösung</translation>
    </message>
    <message>
        <source>Screen: 96 dots per inch</source>
        <translation>Bildschirm: 96 Punkte je Zoll</translation>
    </message>
    <message>
        <source>Slides: 150 dots per inch</source>
        <translation>Folien: 150 Punkte je Zoll</translation>
    </message>
    <message>
        <source>Print: 300 dots per inch</source>
        <translation>Druck: 300 Punkte je Zoll</translation>
    </message>
    <message>
        <source>Fine print: 600 dots per inch</source>
        <translation>Feiner Druck: 600 Punkte je Zoll</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>none: sharp at any size</source>
        <translation>keine: scharf in jeder Größe</translation>
    </message>
    <message>
        <source>%1 wide</source>
        <translation>%1 breit</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>SVG: lines and texts, for editing</source>
        <translation>SVG: Linien und Texte, zum Bearbeiten</translation>
    </message>
    <message>
        <source>PDF: lines and texts, for papers</source>
        <translation>PDF: Linien und Texte, für Veröffentlichungen</translation>
    </message>
    <message>
        <source>JPEG</source>
        <translation>JPEG</translation>
    </message>
</context>
<context>
    <name>Film</name>
    <message>
        <source>after %1 s it has reached %2 MB, the most that an AVI file can hold; make the window smaller, or the run shorter</source>
        <translation>nach %1 s hat er %2 MB erreicht, mehr fasst eine AVI-Datei nicht; machen Sie das Fenster kleiner oder den Lauf kürzer</translation>
    </message>
</context>
<context>
    <name>Labels</name>
    <message>
        <source>goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>goal of %1</source>
        <translation>Ziel von %1</translation>
    </message>
</context>
<context>
    <name>Languages</name>
    <message>
        <source>English</source>
        <translation>Englisch</translation>
    </message>
    <message>
        <source>German</source>
        <translation>Deutsch</translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>%1 has been stuck for %2 s: %3 and %4 cancel each other.</source>
        <translation>%1 steckt seit %2 s fest: %3 und %4 heben einander auf.</translation>
    </message>
    <message>
        <source>%1 has been stuck for %2 s: %3 drives it against something.</source>
        <translation>%1 steckt seit %2 s fest: %3 treibt ihn gegen etwas.</translation>
    </message>
    <message>
        <source>%1 has turned on the spot for %2 s: %3 decides.</source>
        <translation>%1 dreht sich seit %2 s auf der Stelle: %3 entscheidet.</translation>
    </message>
    <message>
        <source>%1 has stood still for %2 s: its battery is empty.</source>
        <translation>%1 steht seit %2 s still: Sein Akku ist leer.</translation>
    </message>
    <message>
        <source>%1 has stood still for %2 s: no behaviour asks it to move.</source>
        <translation>%1 steht seit %2 s still: Kein Verhalten verlangt eine Bewegung.</translation>
    </message>
    <message>
        <source>%1 ended %2 m away from the place that it should reach.</source>
        <translation>%1 war am Ende %2 m von dem Ort entfernt, den er erreichen sollte.</translation>
    </message>
    <message>
        <source>%1 should have driven %2 m farther.</source>
        <translation>%1 hätte %2 m weiter fahren sollen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; ended %2 m away from the place to which it should be pushed.</source>
        <translation>&apos;%1&apos; war am Ende %2 m von dem Ort entfernt, an den es geschoben werden sollte.</translation>
    </message>
    <message>
        <source>%1 touched &apos;%2&apos; at %3 s.</source>
        <translation>%1 berührte &apos;%2&apos; bei %3 s.</translation>
    </message>
    <message>
        <source>The battery of %1 was empty at %2 s.</source>
        <translation>Der Akku von %1 war bei %2 s leer.</translation>
    </message>
    <message>
        <source>Success after %1 s</source>
        <translation>Erfolg nach %1 s</translation>
    </message>
    <message>
        <source>Failed after %1 s</source>
        <translation>Gescheitert nach %1 s</translation>
    </message>
    <message>
        <source>Time is up after %1 s</source>
        <translation>Zeit abgelaufen nach %1 s</translation>
    </message>
    <message>
        <source>Ended after %1 s</source>
        <translation>Beendet nach %1 s</translation>
    </message>
    <message>
        <source>Stopped after %1 s</source>
        <translation>Abgebrochen nach %1 s</translation>
    </message>
    <message>
        <source>The run was stopped</source>
        <translation>Der Lauf wurde abgebrochen</translation>
    </message>
    <message>
        <source>Other robots that stood still: %1.</source>
        <translation>Andere Roboter, die still standen: %1.</translation>
    </message>
    <message>
        <source>Resources that were not collected: %1 of %2.</source>
        <translation>Nicht gesammelte Rohstoffe: %1 von %2.</translation>
    </message>
    <message>
        <source>Events &apos;%1&apos; that a goal asks for and that did not happen: %2 of %3.</source>
        <translation>Ereignisse &apos;%1&apos;, die ein Ziel verlangt und die nicht eintraten: %2 von %3.</translation>
    </message>
</context>
<context>
    <name>Vocabulary</name>
    <message>
        <source>world</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>arena</source>
        <translation>Arena</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>physics</source>
        <translation>Physik</translation>
    </message>
    <message>
        <source>robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>behaviors</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>behavior</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>coordinator</source>
        <translation>Koordinator</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>localisation</source>
        <translation>Ortung</translation>
    </message>
    <message>
        <source>actuators</source>
        <translation>Aktoren</translation>
    </message>
    <message>
        <source>actuator</source>
        <translation>Aktor</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>obstacles</source>
        <translation>Hindernisse</translation>
    </message>
    <message>
        <source>static_box</source>
        <translation>Feste Kiste</translation>
    </message>
    <message>
        <source>dynamic_box</source>
        <translation>Dynamische Kiste</translation>
    </message>
    <message>
        <source>moving_box</source>
        <translation>Bewegte Kiste</translation>
    </message>
    <message>
        <source>static_cylinder</source>
        <translation>Fester Zylinder</translation>
    </message>
    <message>
        <source>dynamic_cylinder</source>
        <translation>Dynamischer Zylinder</translation>
    </message>
    <message>
        <source>moving_cylinder</source>
        <translation>Bewegter Zylinder</translation>
    </message>
    <message>
        <source>static_sphere</source>
        <translation>Feste Kugel</translation>
    </message>
    <message>
        <source>dynamic_sphere</source>
        <translation>Dynamische Kugel</translation>
    </message>
    <message>
        <source>moving_sphere</source>
        <translation>Bewegte Kugel</translation>
    </message>
    <message>
        <source>static_prism</source>
        <translation>Festes Prisma</translation>
    </message>
    <message>
        <source>dynamic_prism</source>
        <translation>Dynamisches Prisma</translation>
    </message>
    <message>
        <source>moving_prism</source>
        <translation>Bewegtes Prisma</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>Wegpunkt</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>resources</source>
        <translation>Rohstoffe</translation>
    </message>
    <message>
        <source>resource</source>
        <translation>Rohstoff</translation>
    </message>
    <message>
        <source>chargers</source>
        <translation>Ladestationen</translation>
    </message>
    <message>
        <source>charger</source>
        <translation>Ladestation</translation>
    </message>
    <message>
        <source>nests</source>
        <translation>Nester</translation>
    </message>
    <message>
        <source>nest</source>
        <translation>Nest</translation>
    </message>
    <message>
        <source>lamps</source>
        <translation>Lampen</translation>
    </message>
    <message>
        <source>lamp</source>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>patches</source>
        <translation>Flecken</translation>
    </message>
    <message>
        <source>patch</source>
        <translation>Fleck</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>fields</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>goals</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>measures</source>
        <translation>Messgrößen</translation>
    </message>
    <message>
        <source>rules</source>
        <translation>Regeln</translation>
    </message>
    <message>
        <source>teams</source>
        <translation>Teams</translation>
    </message>
    <message>
        <source>team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>failure</source>
        <translation>Ausfall</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>states</source>
        <translation>Zustände</translation>
    </message>
    <message>
        <source>format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>id</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>heading_deg</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>bounce</source>
        <translation>Rückprall</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>max_speed</source>
        <translation>Höchstgeschwindigkeit</translation>
    </message>
    <message>
        <source>battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>energy_cost</source>
        <translation>Energiebedarf</translation>
    </message>
    <message>
        <source>leader</source>
        <translation>Anführer</translation>
    </message>
    <message>
        <source>coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>priority</source>
        <translation>Priorität</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>wall_time</source>
        <translation>Wanduhrzeit</translation>
    </message>
    <message>
        <source>wall_height</source>
        <translation>Wandhöhe</translation>
    </message>
    <message>
        <source>wall_thickness</source>
        <translation>Wanddicke</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>control_steps</source>
        <translation>Schritte je Regeltakt</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>engine</source>
        <translation>Engine</translation>
    </message>
    <message>
        <source>count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <source>duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>half_life</source>
        <translation>Halbwertszeit</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>image_length</source>
        <translation>Länge des Bildes</translation>
    </message>
    <message>
        <source>image_width</source>
        <translation>Breite des Bildes</translation>
    </message>
    <message>
        <source>axle</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>wheel_radius</source>
        <translation>Radradius</translation>
    </message>
    <message>
        <source>wheel_width</source>
        <translation>Radbreite</translation>
    </message>
    <message>
        <source>wheel_mass</source>
        <translation>Radmasse</translation>
    </message>
    <message>
        <source>wheel_slip</source>
        <translation>Radschlupf</translation>
    </message>
    <message>
        <source>wheel_torque</source>
        <translation>Raddrehmoment</translation>
    </message>
    <message>
        <source>pitch_deg</source>
        <translation>Nickwinkel</translation>
    </message>
    <message>
        <source>yaw_deg</source>
        <translation>Gierwinkel</translation>
    </message>
    <message>
        <source>max_pitch_deg</source>
        <translation>Größter Nickwinkel</translation>
    </message>
    <message>
        <source>max_yaw_deg</source>
        <translation>Größter Gierwinkel</translation>
    </message>
    <message>
        <source>seen_by_range_sensors</source>
        <translation>Für Abstandssensoren sichtbar</translation>
    </message>
    <message>
        <source>hands</source>
        <translation>Hände</translation>
    </message>
    <message>
        <source>full</source>
        <translation>Voll</translation>
    </message>
    <message>
        <source>hitch</source>
        <translation>Kupplung</translation>
    </message>
    <message>
        <source>hitch_height</source>
        <translation>Höhe der Kupplung</translation>
    </message>
    <message>
        <source>observe</source>
        <translation>Beobachten</translation>
    </message>
    <message>
        <source>act</source>
        <translation>Handeln</translation>
    </message>
    <message>
        <source>path</source>
        <translation>Pfad</translation>
    </message>
    <message>
        <source>all</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>any</source>
        <translation>Eines davon</translation>
    </message>
    <message>
        <source>border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>cfm</source>
        <translation>CFM</translation>
    </message>
    <message>
        <source>change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>changes</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>collect</source>
        <translation>Einsammeln</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>coordination</source>
        <translation>Koordination</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>deliver</source>
        <translation>Abliefern</translation>
    </message>
    <message>
        <source>density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>disc_patch</source>
        <translation>Runder Fleck</translation>
    </message>
    <message>
        <source>door</source>
        <translation>Tür</translation>
    </message>
    <message>
        <source>draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>endure</source>
        <translation>Durchhalten</translation>
    </message>
    <message>
        <source>erp</source>
        <translation>ERP</translation>
    </message>
    <message>
        <source>even</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>floor_plan</source>
        <translation>Grundriss</translation>
    </message>
    <message>
        <source>from</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>from_deg</source>
        <translation>Von Winkel</translation>
    </message>
    <message>
        <source>gather</source>
        <translation>Versammeln</translation>
    </message>
    <message>
        <source>gaussian</source>
        <translation>Gaußverteilt</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>in_box</source>
        <translation>Im Rechteck</translation>
    </message>
    <message>
        <source>in_disc</source>
        <translation>Im Kreis</translation>
    </message>
    <message>
        <source>in_ring</source>
        <translation>Im Ring</translation>
    </message>
    <message>
        <source>inner</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>jitter</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>kd</source>
        <translation>KD</translation>
    </message>
    <message>
        <source>keep_clear</source>
        <translation>Freihalten</translation>
    </message>
    <message>
        <source>kp</source>
        <translation>KP</translation>
    </message>
    <message>
        <source>layouts</source>
        <translation>Anordnungen</translation>
    </message>
    <message>
        <source>learning</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>line_patch</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>maze</source>
        <translation>Labyrinth</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>metres_per_pixel</source>
        <translation>Meter je Bildpunkt</translation>
    </message>
    <message>
        <source>no_collision</source>
        <translation>Keine Kollision</translation>
    </message>
    <message>
        <source>of</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>on_grid</source>
        <translation>Auf einem Gitter</translation>
    </message>
    <message>
        <source>on_line</source>
        <translation>Auf einer Linie</translation>
    </message>
    <message>
        <source>outer</source>
        <translation>Außen</translation>
    </message>
    <message>
        <source>polygon_patch</source>
        <translation>Vieleckiger Fleck</translation>
    </message>
    <message>
        <source>push</source>
        <translation>Schieben</translation>
    </message>
    <message>
        <source>reach</source>
        <translation>Erreichen</translation>
    </message>
    <message>
        <source>rectangle_patch</source>
        <translation>Rechteckiger Fleck</translation>
    </message>
    <message>
        <source>remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>rooms</source>
        <translation>Räume</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>scatter</source>
        <translation>Verstreuen</translation>
    </message>
    <message>
        <source>sd</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>sd_deg</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>segment</source>
        <translation>Wagen</translation>
    </message>
    <message>
        <source>segments</source>
        <translation>Wagen</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>smallest</source>
        <translation>Kleinster</translation>
    </message>
    <message>
        <source>threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>to</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>to_deg</source>
        <translation>Bis Winkel</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>Fahren</translation>
    </message>
    <message>
        <source>tries</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>whole</source>
        <translation>Ganz</translation>
    </message>
    <message>
        <source>x1</source>
        <translation>X1</translation>
    </message>
    <message>
        <source>x2</source>
        <translation>X2</translation>
    </message>
    <message>
        <source>y1</source>
        <translation>Y1</translation>
    </message>
    <message>
        <source>y2</source>
        <translation>Y2</translation>
    </message>
</context>
<context>
    <name>elsie::desktop</name>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>As a &amp;table...</source>
        <translation>Als &amp;Tabelle...</translation>
    </message>
    <message>
        <source>&amp;Again</source>
        <translation>&amp;Noch einmal</translation>
    </message>
    <message>
        <source>The figures of this instant</source>
        <translation>Die Werte dieses Augenblicks</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a name of a picture: it must end with .png or .jpg.</source>
        <translation>&apos;%1&apos; ist kein Name eines Bildes: er muss auf .png oder .jpg enden.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be written: %2.</source>
        <translation>&apos;%1&apos; kann nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>The picture could not be written to &apos;%1&apos;: %2. What was there before is unchanged.</source>
        <translation>Das Bild konnte nicht nach &apos;%1&apos; geschrieben werden: %2. Was dort stand, ist unverändert.</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::Authoring</name>
    <message>
        <source>&amp;static box</source>
        <translation>&amp;feste Kiste</translation>
    </message>
    <message>
        <source>&amp;dynamic box</source>
        <translation>&amp;dynamische Kiste</translation>
    </message>
    <message>
        <source>&amp;moving box</source>
        <translation>&amp;bewegte Kiste</translation>
    </message>
    <message>
        <source>There is no world to add to: open one, or make a new one.</source>
        <translation>Es gibt keine Welt, zu der etwas hinzugefügt werden kann: Öffnen Sie eine, oder legen Sie eine neue an.</translation>
    </message>
    <message>
        <source>Select the robot first.</source>
        <translation>Wählen Sie zuerst den Roboter aus.</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>clear the network</source>
        <translation>Netz leeren</translation>
    </message>
    <message>
        <source>&amp;Edit...</source>
        <translation>&amp;Bearbeiten...</translation>
    </message>
    <message>
        <source>Add &amp;sensor...</source>
        <translation>&amp;Sensor hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;actuator...</source>
        <translation>&amp;Aktor hinzufügen...</translation>
    </message>
    <message>
        <source>&amp;Behaviours...</source>
        <translation>&amp;Verhalten...</translation>
    </message>
    <message>
        <source>&amp;Coordinator...</source>
        <translation>&amp;Koordinator...</translation>
    </message>
    <message>
        <source>Add ele&amp;ment...</source>
        <translation>Ele&amp;ment hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;waypoint</source>
        <translation>&amp;Wegpunkt hinzufügen</translation>
    </message>
    <message>
        <source>Add &amp;point</source>
        <translation>&amp;Punkt hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Follow</source>
        <translation>&amp;Folgen</translation>
    </message>
    <message>
        <source>Make &amp;start pose</source>
        <translation>Als Start&amp;pose übernehmen</translation>
    </message>
    <message>
        <source>&amp;Replace...</source>
        <translation>&amp;Ersetzen...</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Add &amp;robot here...</source>
        <translation>&amp;Roboter hier hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;robot...</source>
        <translation>&amp;Roboter hinzufügen...</translation>
    </message>
    <message>
        <source>Add %1 here...</source>
        <translation>%1 hier hinzufügen...</translation>
    </message>
    <message>
        <source>Add %1...</source>
        <translation>%1 hinzufügen...</translation>
    </message>
    <message>
        <source>Add r&amp;esource here...</source>
        <translation>Roh&amp;stoff hier hinzufügen...</translation>
    </message>
    <message>
        <source>Add r&amp;esource...</source>
        <translation>Roh&amp;stoff hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;charger here...</source>
        <translation>&amp;Ladestation hier hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;charger...</source>
        <translation>&amp;Ladestation hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;nest here...</source>
        <translation>&amp;Nest hier hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;nest...</source>
        <translation>&amp;Nest hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;lamp here...</source>
        <translation>L&amp;ampe hier hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;lamp...</source>
        <translation>L&amp;ampe hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;patch of the floor here...</source>
        <translation>&amp;Fleck auf dem Boden hier hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;patch of the floor...</source>
        <translation>&amp;Fleck auf dem Boden hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;goal...</source>
        <translation>&amp;Ziel hinzufügen...</translation>
    </message>
    <message>
        <source>Add meas&amp;ure...</source>
        <translation>&amp;Messgröße hinzufügen...</translation>
    </message>
    <message>
        <source>Add rule...</source>
        <translation>Regel hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;team...</source>
        <translation>&amp;Team hinzufügen...</translation>
    </message>
    <message>
        <source>Add &amp;field...</source>
        <translation>F&amp;eld hinzufügen...</translation>
    </message>
    <message>
        <source>Pas&amp;te</source>
        <translation>Ein&amp;fügen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no name of its own.</source>
        <translation>&apos;%1&apos; hat keinen eigenen Namen.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Name von %1</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>make start pose</source>
        <translation>Startpose übernehmen</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message numerus="yes">
        <source>move %n things</source>
        <translation>
            <numerusform>%n Ding verschieben</numerusform>
            <numerusform>%n Dinge verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>resize %1</source>
        <translation>Größe von %1 ändern</translation>
    </message>
    <message>
        <source>delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message numerus="yes">
        <source>delete %n things</source>
        <translation>
            <numerusform>%n Ding löschen</numerusform>
            <numerusform>%n Dinge löschen</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is selected that can be deleted.</source>
        <translation>Es ist nichts ausgewählt, was gelöscht werden kann.</translation>
    </message>
    <message>
        <source>paste</source>
        <translation>einfügen</translation>
    </message>
    <message>
        <source>duplicate</source>
        <translation>duplizieren</translation>
    </message>
    <message>
        <source>There is nothing to paste: copy elements of a world first.</source>
        <translation>Es gibt nichts einzufügen: Kopieren Sie zuerst Elemente einer Welt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not an element that can be pasted into a world.</source>
        <translation>&apos;%1&apos; ist kein Element, das in eine Welt eingefügt werden kann.</translation>
    </message>
    <message>
        <source>Select the robot that &apos;%1&apos; is for.</source>
        <translation>Wählen Sie den Roboter aus, für den &apos;%1&apos; ist.</translation>
    </message>
    <message>
        <source>&amp;Add one with its parameters...</source>
        <translation>Eines mit seinen Parametern &amp;hinzufügen...</translation>
    </message>
    <message>
        <source>&amp;Add %1...</source>
        <translation>%1 &amp;hinzufügen...</translation>
    </message>
    <message>
        <source>The coordinator of %1 is being edited in this dialog.</source>
        <translation>Der Koordinator von %1 wird in diesem Dialog bearbeitet.</translation>
    </message>
    <message>
        <source>&amp;Clear the network</source>
        <translation>&amp;Netz leeren</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::BehaviorsDialog</name>
    <message>
        <source>Behaviours of %1</source>
        <translation>Verhalten von %1</translation>
    </message>
    <message>
        <source>&amp;Pool</source>
        <translation>&amp;Vorrat</translation>
    </message>
    <message>
        <source>&amp;Carried</source>
        <translation>&amp;Zugeteilt</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Give the robot the selected behaviour</source>
        <translation>Dem Roboter das ausgewählte Verhalten geben</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected behaviour</source>
        <translation>Das ausgewählte Verhalten entfernen</translation>
    </message>
    <message>
        <source>change behaviours of %1</source>
        <translation>Verhalten von %1 ändern</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::Card</name>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::CodeEditor</name>
    <message>
        <source>Find...</source>
        <translation>Suchen...</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Type some letters of a command, a robot, a file; or speed 2</source>
        <translation>Einige Buchstaben eines Befehls, eines Roboters, einer Datei; oder Tempo 2</translation>
    </message>
    <message>
        <source>Letters of the command</source>
        <translation>Buchstaben des Befehls</translation>
    </message>
    <message>
        <source>Commands that fit</source>
        <translation>Passende Befehle</translation>
    </message>
    <message>
        <source>Enter does it, Up and Down choose, Esc closes</source>
        <translation>Eingabe führt aus, Auf und Ab wählen, Esc schließt</translation>
    </message>
    <message>
        <source>Nothing fits &apos;%1&apos;.</source>
        <translation>Nichts passt zu &apos;%1&apos;.</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::ControlBar</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Run one control period (F10)</source>
        <translation>Einen Regeltakt ausführen (F10)</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the start, with the world as it is now (Ctrl+R)</source>
        <translation>Zurück zum Anfang, mit der Welt, wie sie jetzt ist (Strg+R)</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>&amp;Tempo</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Simulated seconds for each second on the clock</source>
        <translation>Simulierte Sekunden je Sekunde auf der Uhr</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>höchstes</translation>
    </message>
    <message>
        <source>See&amp;d</source>
        <translation>Start&amp;wert</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Seed of all random numbers; a new one starts the run again</source>
        <translation>Startwert aller Zufallszahlen; ein neuer beginnt den Lauf von vorn</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a seed; expected a whole number of at most 19 digits.</source>
        <translation>&apos;%1&apos; ist kein Startwert; erwartet wird eine ganze Zahl mit höchstens 19 Ziffern.</translation>
    </message>
    <message>
        <source>Start or continue the run; after its end, start it again (F5)</source>
        <translation>Den Lauf starten oder fortsetzen; nach seinem Ende von vorn beginnen (F5)</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::ControlSurface</name>
    <message>
        <source>Control surface</source>
        <translation>Kennfeld</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Input across</source>
        <translation>Eingang waagerecht</translation>
    </message>
    <message>
        <source>Input upwards</source>
        <translation>Eingang senkrecht</translation>
    </message>
    <message>
        <source>over</source>
        <translation>über</translation>
    </message>
    <message>
        <source>and</source>
        <translation>und</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::CoordinationPanel</name>
    <message>
        <source>Coordination</source>
        <translation>Koordination</translation>
    </message>
    <message>
        <source>behaviour</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>activation</source>
        <translation>Aktivierung</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>share [%]</source>
        <translation>Anteil [%]</translation>
    </message>
    <message>
        <source>command [m/s, m/s, rad/s]</source>
        <translation>Kommando [m/s, m/s, rad/s]</translation>
    </message>
    <message>
        <source>inhibited by</source>
        <translation>gehemmt von</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>not asked</source>
        <translation>nicht gefragt</translation>
    </message>
    <message>
        <source>%1: activation %2, weight %3, share %4 %</source>
        <translation>%1: Aktivierung %2, Gewicht %3, Anteil %4 %</translation>
    </message>
    <message>
        <source>%1: not asked</source>
        <translation>%1: nicht gefragt</translation>
    </message>
    <message>
        <source>
command (forward m/s, lateral m/s, turn rad/s): %1</source>
        <translation>
Kommando (vorwärts m/s, seitwärts m/s, Drehrate rad/s): %1</translation>
    </message>
    <message>
        <source>
priority in the world: %1</source>
        <translation>
Priorität in der Welt: %1</translation>
    </message>
    <message>
        <source>
inhibited by %1</source>
        <translation>
gehemmt von %1</translation>
    </message>
    <message>
        <source>Select a robot to see which behaviour decides</source>
        <translation>Wählen Sie einen Roboter aus, um zu sehen, welches Verhalten entscheidet</translation>
    </message>
    <message>
        <source>Nothing from %1 yet: this panel is updated only while it is visible</source>
        <translation>Noch nichts von %1: Dieses Feld wird nur erneuert, solange es zu sehen ist</translation>
    </message>
    <message>
        <source>activation %1  </source>
        <translation>Aktivierung %1  </translation>
    </message>
    <message>
        <source>weight %1  share %2 %  (%3)</source>
        <translation>Gewicht %1  Anteil %2 %  (%3)</translation>
    </message>
    <message>
        <source>priority %1  not asked</source>
        <translation>Priorität %1  nicht gefragt</translation>
    </message>
    <message>
        <source>command: forward, lateral [m/s], turn [rad/s]</source>
        <translation>Kommando: vorwärts, seitwärts [m/s], Drehung [rad/s]</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>the reason is not stored</source>
        <translation>der Grund ist nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::ElementDialog</name>
    <message>
        <source>Kinds</source>
        <translation>Arten</translation>
    </message>
    <message>
        <source>Apply changes &amp;immediately</source>
        <translation>Änderungen &amp;sofort anwenden</translation>
    </message>
    <message>
        <source>element</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>New %1</source>
        <translation>%1: neu</translation>
    </message>
    <message>
        <source>New %1 of %2</source>
        <translation>%1: neu in %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>There is nothing to edit at &apos;%1&apos;.</source>
        <translation>Bei &apos;%1&apos; gibt es nichts zu bearbeiten.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no parameters: there is nothing to set.</source>
        <translation>&apos;%1&apos; hat keine Parameter: Es gibt nichts einzustellen.</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>%1 bearbeiten</translation>
    </message>
    <message>
        <source>set %1 of %2</source>
        <translation>%1 von %2 setzen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is required: %2.</source>
        <translation>&apos;%1&apos; ist erforderlich: %2.</translation>
    </message>
    <message>
        <source>edit %1</source>
        <translation>%1 bearbeiten</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>replace %1</source>
        <translation>%1 ersetzen</translation>
    </message>
    <message>
        <source>goal in it</source>
        <translation>Ziel darin</translation>
    </message>
    <message>
        <source>of a regular polygon, whose points can be moved later</source>
        <translation>eines regelmäßigen Vielecks, dessen Punkte später verschoben werden können</translation>
    </message>
    <message>
        <source>at least 3 and at most 16</source>
        <translation>mindestens 3 und höchstens 16</translation>
    </message>
    <message>
        <source>of the circle through its corners</source>
        <translation>des Kreises durch seine Ecken</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>&amp;Random heading</source>
        <translation>&amp;Zufällige Richtung</translation>
    </message>
    <message>
        <source>Draws the heading from 0 to %1 degrees</source>
        <translation>Wählt die Richtung zufällig zwischen 0 und %1 Grad</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>The training has used up its presentations without reaching its goal, a mean error below %1.</source>
        <translation>Das Training hat alle Darbietungen verbraucht, ohne sein Ziel zu erreichen: einen mittleren Fehler unter %1.</translation>
    </message>
    <message>
        <source>%1 OK uses it anyway.</source>
        <translation>%1 OK verwendet es trotzdem.</translation>
    </message>
    <message>
        <source>cancel the edit of %1</source>
        <translation>Bearbeiten von %1 abbrechen</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::Engine</name>
    <message>
        <source>The engine sent an unreadable message: %1</source>
        <translation>Die Engine hat eine unlesbare Nachricht gesendet: %1</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::Exporter</name>
    <message>
        <source>Export the picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>The picture is in &apos;%1&apos;</source>
        <translation>Das Bild ist in &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Not exported</source>
        <translation>Nicht exportiert</translation>
    </message>
    <message>
        <source>There is no run to show: run the world first.</source>
        <translation>Es gibt keinen Lauf zu zeigen: Lassen Sie zuerst die Welt laufen.</translation>
    </message>
    <message>
        <source>Export the film</source>
        <translation>Film exportieren</translation>
    </message>
    <message>
        <source>Writing &apos;%1&apos;</source>
        <translation>&apos;%1&apos; wird geschrieben</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 pictures in &apos;%2&apos;</source>
        <translation>%1 Bilder in &apos;%2&apos;</translation>
    </message>
    <message>
        <source>The film could not be written to &apos;%1&apos;: %2. What was there before is unchanged.</source>
        <translation>Der Film konnte nicht nach &apos;%1&apos; geschrieben werden: %2. Was dort stand, ist unverändert.</translation>
    </message>
    <message>
        <source>Record the next run: 10 samples per simulated second</source>
        <translation>Nächsten Lauf aufzeichnen: 10 Werte je simulierter Sekunde</translation>
    </message>
    <message>
        <source>Recordings (*.mcap *.csv)</source>
        <translation>Aufzeichnungen (*.mcap *.csv)</translation>
    </message>
    <message>
        <source>The next run is recorded in &apos;%1&apos;</source>
        <translation>Der nächste Lauf wird in &apos;%1&apos; aufgezeichnet</translation>
    </message>
    <message>
        <source>There is no world yet.</source>
        <translation>Es gibt noch keine Welt.</translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation>Kopiert: %1</translation>
    </message>
    <message>
        <source>Copied, but the command gives a different run, because its file has changed since this run began. %1</source>
        <translation>Kopiert, aber der Befehl ergibt einen anderen Lauf, weil seine Datei seit dem Beginn dieses Laufs geändert wurde. %1</translation>
    </message>
    <message>
        <source>the world was changed meanwhile</source>
        <translation>die Welt wurde inzwischen geändert</translation>
    </message>
    <message>
        <source>Pictures (*.%1)</source>
        <translation>Bilder (*.%1)</translation>
    </message>
    <message>
        <source>The graphics of this machine draws no picture of %1 x %2 pixels. Choose fewer dots per inch.</source>
        <translation>Die Grafik dieses Rechners zeichnet kein Bild von %1 x %2 Pixeln. Wählen Sie weniger Punkte je Zoll.</translation>
    </message>
    <message>
        <source>A film is being written already.</source>
        <translation>Es wird bereits ein Film geschrieben.</translation>
    </message>
    <message>
        <source>Films (*.%1)</source>
        <translation>Filme (*.%1)</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>the run went on meanwhile; pause it until the film is written</source>
        <translation>der Lauf ging inzwischen weiter; halten Sie ihn an, bis der Film geschrieben ist</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not end in .mp4, .webm, .gif or .avi, as the name of a film does.</source>
        <translation>&apos;%1&apos; endet nicht auf .mp4, .webm, .gif oder .avi, wie der Name eines Films.</translation>
    </message>
    <message>
        <source>the time was moved all the while</source>
        <translation>die Zeit wurde die ganze Zeit verstellt</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::Fan</name>
    <message>
        <source>How many sensors of this kind are added at once</source>
        <translation>Wie viele Sensoren dieser Art auf einmal hinzugefügt werden</translation>
    </message>
    <message>
        <source>Ho&amp;w many</source>
        <translation>A&amp;nzahl</translation>
    </message>
    <message>
        <source>The angle between the first and the last; 360: a ring</source>
        <translation>Der Winkel zwischen dem ersten und dem letzten; 360: ein Ring</translation>
    </message>
    <message>
        <source>&amp;over</source>
        <translation>&amp;über</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::FindBar</name>
    <message>
        <source>Find in the text</source>
        <translation>Im Text suchen</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Find the previous one (Shift+Enter)</source>
        <translation>Vorherige Stelle suchen (Umschalt+Eingabe)</translation>
    </message>
    <message>
        <source>Find the next (Enter)</source>
        <translation>Nächste Stelle suchen (Eingabe)</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>continued from the other end</source>
        <translation>am anderen Ende fortgesetzt</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::Form</name>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Fuzzy models (*.fcl)</source>
        <translation>Fuzzy-Modelle (*.fcl)</translation>
    </message>
    <message>
        <source>Weights of networks (*.weights)</source>
        <translation>Gewichte von Netzen (*.weights)</translation>
    </message>
    <message>
        <source>Robots (*.xml)</source>
        <translation>Roboter (*.xml)</translation>
    </message>
    <message>
        <source>default: %1</source>
        <translation>Vorgabe: %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is required.</source>
        <translation>&apos;%1&apos; ist erforderlich.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a %2; write it with a point, as in 1.5.</source>
        <translation>&apos;%1&apos; ist keine %2; schreiben Sie sie mit einem Punkt, wie in 1.5.</translation>
    </message>
    <message>
        <source>whole number</source>
        <translation>ganze Zahl</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>%1 is out of range: expected a number %2 %3</source>
        <translation>%1 ist außerhalb des Bereichs: Erwartet wird eine Zahl %2 %3</translation>
    </message>
    <message>
        <source>...</source>
        <translation>...</translation>
    </message>
    <message>
        <source>Browse for the file</source>
        <translation>Die Datei suchen</translation>
    </message>
    <message>
        <source>File for &apos;%1&apos;</source>
        <translation>Datei für &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Pick...</source>
        <translation>Wählen...</translation>
    </message>
    <message>
        <source>Default of %1</source>
        <translation>Vorgabe von %1</translation>
    </message>
    <message>
        <source>Remove the value</source>
        <translation>Den Wert entfernen</translation>
    </message>
    <message>
        <source>Back to the default, %1</source>
        <translation>Zurück zur Vorgabe, %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>%1 without unit</source>
        <translation>%1 ohne Einheit</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::FuzzyPanel</name>
    <message>
        <source>what</source>
        <translation>was</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>No fuzzy model of this robot has decided yet</source>
        <translation>Noch hat kein Fuzzy-Modell dieses Roboters entschieden</translation>
    </message>
    <message>
        <source>Fuzzy model</source>
        <translation>Fuzzy-Modell</translation>
    </message>
    <message>
        <source>Inputs, rules and outputs of the fuzzy model</source>
        <translation>Eingänge, Regeln und Ausgänge des Fuzzy-Modells</translation>
    </message>
    <message>
        <source>   centre of gravity %1</source>
        <translation>   Schwerpunkt %1</translation>
    </message>
    <message>
        <source>The values at %1 s are not stored: they are while this window is shown and the model is asked.</source>
        <translation>Die Werte bei %1 s sind nicht gespeichert: Sie werden es nur, solange dieses Fenster zu sehen ist und das Modell gefragt wird.</translation>
    </message>
    <message>
        <source>Opens the rules and terms of this model as a text</source>
        <translation>Öffnet die Regeln und Terme dieses Modells als Text</translation>
    </message>
    <message>
        <source>Edit...</source>
        <translation>Bearbeiten...</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::GraphPanel</name>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>success</source>
        <translation>Erfolg</translation>
    </message>
    <message>
        <source>failure</source>
        <translation>Fehlschlag</translation>
    </message>
    <message>
        <source>Select a robot to see the states or the tree of its coordinator</source>
        <translation>Wählen Sie einen Roboter aus, um die Zustände oder den Baum seines Koordinators zu sehen</translation>
    </message>
    <message>
        <source>Nothing from %1 yet: this panel is updated only while it is visible</source>
        <translation>Noch nichts von %1: Dieses Feld wird nur erneuert, solange es zu sehen ist</translation>
    </message>
    <message>
        <source>The coordinator of %1 shows no graph; arbiter_states and arbiter_tree do</source>
        <translation>Der Koordinator von %1 zeigt keinen Graphen; arbiter_states und arbiter_tree tun es</translation>
    </message>
    <message>
        <source>coordinator</source>
        <translation>Koordinator</translation>
    </message>
    <message>
        <source>node</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>%1 nodes are too many to be drawn; of a recording, elsie explain lists them</source>
        <translation>%1 Knoten sind zu viele, um sie zu zeichnen; bei einer Aufzeichnung listet elsie explain sie auf</translation>
    </message>
    <message>
        <source>States or tree of the coordinators</source>
        <translation>Zustände oder Baum der Koordinatoren</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Page of the documentation</source>
        <translation>Seite der Dokumentation</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;Forward</source>
        <translation>&amp;Vorwärts</translation>
    </message>
    <message>
        <source>&amp;Tutorial</source>
        <translation>&amp;Tutorial</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::LearningCurve</name>
    <message>
        <source>Learning curve</source>
        <translation>Lernkurve</translation>
    </message>
    <message>
        <source>samples presented</source>
        <translation>dargebotene Beispiele</translation>
    </message>
    <message>
        <source>mean error</source>
        <translation>mittlerer Fehler</translation>
    </message>
    <message>
        <source>The training draws its learning curve here</source>
        <translation>Hier zeichnet das Training seine Lernkurve</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::MainWindow</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>new world</source>
        <translation>neue Welt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>höchstes</translation>
    </message>
    <message>
        <source>%1x of %2</source>
        <translation>%1x von %2</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>Startwert %1</translation>
    </message>
    <message>
        <source>no world</source>
        <translation>keine Welt</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>opening the world</source>
        <translation>die Welt wird geöffnet</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>playing the past</source>
        <translation>die Vergangenheit läuft</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>recording %1</source>
        <translation>Aufzeichnung %1</translation>
    </message>
    <message>
        <source>recording %1, %2</source>
        <translation>Aufzeichnung %1, %2</translation>
    </message>
    <message>
        <source>Unloc&amp;k for the mouse</source>
        <translation>Für die Maus &amp;freigeben</translation>
    </message>
    <message>
        <source>Loc&amp;k against the mouse</source>
        <translation>Gegen die Maus s&amp;perren</translation>
    </message>
    <message>
        <source>About Elsie</source>
        <translation>Über Elsie</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Elsie %3&lt;/b&gt;: behaviour-based mobile robot control.&lt;/p&gt;&lt;p&gt;Apache License 2.0. This window uses Qt %1 (LGPL).&lt;/p&gt;&lt;p&gt;The view is drawn by %2.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Elsie %3&lt;/b&gt;: verhaltensbasierte Steuerung mobiler Roboter.&lt;/p&gt;&lt;p&gt;Apache-Lizenz 2.0. Dieses Fenster verwendet Qt %1 (LGPL).&lt;/p&gt;&lt;p&gt;Die Ansicht zeichnet %2.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Qt, as outlines</source>
        <translation>Qt, als Umrisse</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Simulation</source>
        <translation>&amp;Simulation</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Next error</source>
        <translation>Nächster Fehler</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>Ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Open a world, a recording or a run of a database</source>
        <translation>Eine Welt, eine Aufzeichnung oder einen Lauf einer Datenbank öffnen</translation>
    </message>
    <message>
        <source>Worlds and runs (*.xml *.mcap *.sqlite);;All files (*)</source>
        <translation>Welten und Läufe (*.xml *.mcap *.sqlite);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Recent&amp;ly opened</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Start &amp;page</source>
        <translation>Startsei&amp;te</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Speichern &amp;unter...</translation>
    </message>
    <message>
        <source>Export p&amp;icture...</source>
        <translation>B&amp;ild exportieren...</translation>
    </message>
    <message>
        <source>Export &amp;film...</source>
        <translation>Fil&amp;m exportieren...</translation>
    </message>
    <message>
        <source>Writes the run, from its start to now, as a film</source>
        <translation>Schreibt den Lauf vom Anfang bis jetzt als Film</translation>
    </message>
    <message>
        <source>&amp;Record the next run...</source>
        <translation>Nächsten &amp;Lauf aufzeichnen...</translation>
    </message>
    <message>
        <source>Writes it from its start into a CSV or MCAP file, 10 samples per simulated second</source>
        <translation>Schreibt ihn vom Anfang an in eine CSV- oder MCAP-Datei, 10 Werte je simulierter Sekunde</translation>
    </message>
    <message>
        <source>&amp;Copy the command line that repeats this</source>
        <translation>Befehlszeile &amp;kopieren, die dies wiederholt</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Edit...</source>
        <translation>&amp;Bearbeiten...</translation>
    </message>
    <message>
        <source>Re&amp;name...</source>
        <translation>U&amp;mbenennen...</translation>
    </message>
    <message>
        <source>&amp;More for the selection...</source>
        <translation>Me&amp;hr zur Auswahl...</translation>
    </message>
    <message>
        <source>Make &amp;start pose</source>
        <translation>Als Start&amp;pose übernehmen</translation>
    </message>
    <message>
        <source>The selected robots begin where they are now</source>
        <translation>Die ausgewählten Roboter beginnen dort, wo sie jetzt sind</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>Hin&amp;zufügen</translation>
    </message>
    <message>
        <source>&amp;Robot...</source>
        <translation>&amp;Roboter...</translation>
    </message>
    <message>
        <source>Se&amp;nsor...</source>
        <translation>Se&amp;nsor...</translation>
    </message>
    <message>
        <source>Add a sensor to the selected robot</source>
        <translation>Dem ausgewählten Roboter einen Sensor hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Behaviours...</source>
        <translation>&amp;Verhalten...</translation>
    </message>
    <message>
        <source>Choose the behaviours of the selected robot</source>
        <translation>Die Verhalten des ausgewählten Roboters wählen</translation>
    </message>
    <message>
        <source>C&amp;oordinator...</source>
        <translation>&amp;Koordinator...</translation>
    </message>
    <message>
        <source>Choose or edit the coordinator of the selected robot</source>
        <translation>Den Koordinator des ausgewählten Roboters wählen oder bearbeiten</translation>
    </message>
    <message>
        <source>R&amp;esource...</source>
        <translation>Roh&amp;stoff...</translation>
    </message>
    <message>
        <source>&amp;Charger...</source>
        <translation>&amp;Ladestation...</translation>
    </message>
    <message>
        <source>Nest...</source>
        <translation>Nest...</translation>
    </message>
    <message>
        <source>&amp;Lamp...</source>
        <translation>L&amp;ampe...</translation>
    </message>
    <message>
        <source>&amp;Patch of the floor...</source>
        <translation>&amp;Fleck auf dem Boden...</translation>
    </message>
    <message>
        <source>&amp;Goal...</source>
        <translation>&amp;Ziel...</translation>
    </message>
    <message>
        <source>Meas&amp;ure...</source>
        <translation>&amp;Messgröße...</translation>
    </message>
    <message>
        <source>Rule...</source>
        <translation>Regel...</translation>
    </message>
    <message>
        <source>&amp;Team...</source>
        <translation>&amp;Team...</translation>
    </message>
    <message>
        <source>&amp;Field...</source>
        <translation>F&amp;eld...</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>&amp;Alles zeigen</translation>
    </message>
    <message>
        <source>Go &amp;near to the selection</source>
        <translation>Zur Auswahl &amp;heranfahren</translation>
    </message>
    <message>
        <source>From the &amp;top</source>
        <translation>Von &amp;oben</translation>
    </message>
    <message>
        <source>From the &amp;front</source>
        <translation>Von &amp;vorn</translation>
    </message>
    <message>
        <source>From the &amp;side</source>
        <translation>Von der &amp;Seite</translation>
    </message>
    <message>
        <source>F&amp;ollow the selected robot</source>
        <translation>Dem ausgewählten Roboter &amp;folgen</translation>
    </message>
    <message>
        <source>&amp;Measuring tape</source>
        <translation>&amp;Maßband</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Maßband</translation>
    </message>
    <message>
        <source>Tra&amp;jectories</source>
        <translation>&amp;Bahnen</translation>
    </message>
    <message>
        <source>S&amp;ketches of plugins</source>
        <translation>S&amp;kizzen der Plugins</translation>
    </message>
    <message>
        <source>Nam&amp;es</source>
        <translation>&amp;Namen</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Gitter</translation>
    </message>
    <message>
        <source>&amp;Clear trajectories</source>
        <translation>Bahnen &amp;löschen</translation>
    </message>
    <message>
        <source>Contro&amp;l bar</source>
        <translation>Steuerle&amp;iste</translation>
    </message>
    <message>
        <source>Env&amp;ironment bar</source>
        <translation>&amp;Umgebungsleiste</translation>
    </message>
    <message>
        <source>Stat&amp;us bar</source>
        <translation>Stat&amp;usleiste</translation>
    </message>
    <message>
        <source>Win&amp;dows</source>
        <translation>F&amp;enster</translation>
    </message>
    <message>
        <source>Layout: aut&amp;hor</source>
        <translation>Anordnung: ba&amp;uen</translation>
    </message>
    <message>
        <source>Layout: &amp;watch</source>
        <translation>Anordnung: beoba&amp;chten</translation>
    </message>
    <message>
        <source>Layout: t&amp;rain</source>
        <translation>Anordnung: t&amp;rainieren</translation>
    </message>
    <message>
        <source>Reset the la&amp;yout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Next window</source>
        <translation>Nächstes Fenster</translation>
    </message>
    <message>
        <source>&amp;Run or pause</source>
        <translation>&amp;Laufen oder anhalten</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Schritt</translation>
    </message>
    <message>
        <source>R&amp;eset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Go to an event</source>
        <translation>Zu einem &amp;Ereignis</translation>
    </message>
    <message>
        <source>Pre&amp;vious event</source>
        <translation>&amp;Voriges Ereignis</translation>
    </message>
    <message>
        <source>Ne&amp;xt event</source>
        <translation>N&amp;ächstes Ereignis</translation>
    </message>
    <message>
        <source>Back to &amp;now</source>
        <translation>Zurück zum &amp;Jetzt</translation>
    </message>
    <message>
        <source>&amp;Physics parameters...</source>
        <translation>&amp;Physik...</translation>
    </message>
    <message>
        <source>Gravity, ERP and CFM or kp and kd, and the time step; also during a run</source>
        <translation>Schwerkraft, ERP und CFM oder kp und kd und der Zeitschritt; auch während eines Laufs</translation>
    </message>
    <message>
        <source>&amp;Arena...</source>
        <translation>&amp;Arena...</translation>
    </message>
    <message>
        <source>&amp;Floor...</source>
        <translation>&amp;Boden...</translation>
    </message>
    <message>
        <source>&amp;Limits...</source>
        <translation>&amp;Grenzen...</translation>
    </message>
    <message>
        <source>S&amp;top the engine now</source>
        <translation>Die Engine &amp;jetzt anhalten</translation>
    </message>
    <message>
        <source>For a plugin that does not return: the engine starts again, and the world stays</source>
        <translation>Für ein Plugin, das nicht zurückkehrt: Die Engine startet neu, und die Welt bleibt</translation>
    </message>
    <message>
        <source>&amp;Commands...</source>
        <translation>&amp;Befehle...</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>C&amp;hange keys...</source>
        <translation>Tasten &amp;ändern...</translation>
    </message>
    <message>
        <source>The keys of all commands</source>
        <translation>Die Tasten aller Befehle</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>Ü&amp;ber Elsie</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>The text has mistakes: the world is the one from before them.</source>
        <translation>Der Text hat Fehler: Die Welt ist die von davor.</translation>
    </message>
    <message>
        <source>%1
state hash %2</source>
        <translation>%1
Zustands-Hash %2</translation>
    </message>
    <message>
        <source>%1 plugins were found</source>
        <translation>%1 Plugins wurden gefunden</translation>
    </message>
    <message>
        <source>The engine has been reading the world for %1 s: it is large, or a plugin takes long. &apos;Stop the engine now&apos; in the menu Simulation stops it, and the text stays.</source>
        <translation>Die Engine liest die Welt seit %1 s: Sie ist groß, oder ein Plugin braucht lange. &apos;Die Engine jetzt anhalten&apos; im Menü Simulation hält sie an, und der Text bleibt.</translation>
    </message>
    <message>
        <source>The engine does not answer: a plugin takes long. &apos;Stop the engine now&apos; in the menu Simulation starts it again, and the world stays.</source>
        <translation>Die Engine antwortet nicht: Ein Plugin braucht lange. &apos;Die Engine jetzt anhalten&apos; im Menü Simulation startet sie neu, und die Welt bleibt.</translation>
    </message>
    <message>
        <source>The view showed the past, in which nothing can be changed. Now it shows the present.</source>
        <translation>Die Ansicht zeigte die Vergangenheit, in der nichts geändert werden kann. Jetzt zeigt sie die Gegenwart.</translation>
    </message>
    <message>
        <source>from (%1, %2) to (%3, %4): %5 m</source>
        <translation>von (%1, %2) nach (%3, %4): %5 m</translation>
    </message>
    <message>
        <source>The run cannot be opened</source>
        <translation>Der Lauf kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Context menu</source>
        <translation>Kontextmenü</translation>
    </message>
    <message>
        <source>The run failed: %1</source>
        <translation>Der Lauf ist gescheitert: %1</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Errors (%1)</source>
        <translation>Fehler (%1)</translation>
    </message>
    <message>
        <source>The text is not a world yet: it has an error.</source>
        <translation>Der Text ist noch keine Welt: Er hat einen Fehler.</translation>
    </message>
    <message>
        <source>The text is not a world yet: it has %1 errors.</source>
        <translation>Der Text ist noch keine Welt: Er hat %1 Fehler.</translation>
    </message>
    <message>
        <source>There is no engine</source>
        <translation>Es gibt keine Engine</translation>
    </message>
    <message>
        <source>The engine was stopped</source>
        <translation>Die Engine wurde angehalten</translation>
    </message>
    <message>
        <source>The engine was started again</source>
        <translation>Die Engine wurde neu gestartet</translation>
    </message>
    <message>
        <source>You stopped the engine.</source>
        <translation>Sie haben die Engine angehalten.</translation>
    </message>
    <message>
        <source>A plugin ended the engine.</source>
        <translation>Ein Plugin hat die Engine beendet.</translation>
    </message>
    <message>
        <source>The engine ended.</source>
        <translation>Die Engine hat sich beendet.</translation>
    </message>
    <message>
        <source>It does not start again. Your world and its unsaved changes are here as a text, which you can save. Changing the text, or opening a world, tries to start the engine again.</source>
        <translation>Sie startet nicht mehr. Ihre Welt und die ungespeicherten Änderungen sind als Text hier, den Sie speichern können. Wenn Sie den Text ändern oder eine Welt öffnen, wird versucht, die Engine wieder zu starten.</translation>
    </message>
    <message>
        <source>Your world and its unsaved changes are here as a text, which is opened again when you change it.</source>
        <translation>Ihre Welt und die ungespeicherten Änderungen sind als Text hier, der wieder geöffnet wird, wenn Sie ihn ändern.</translation>
    </message>
    <message>
        <source>Your world and its unsaved changes are here; the run stands at its start.</source>
        <translation>Ihre Welt und die ungespeicherten Änderungen sind hier; der Lauf steht am Anfang.</translation>
    </message>
    <message>
        <source>This was not made, and may have ended it: %1.</source>
        <translation>Dies wurde nicht ausgeführt und kann die Ursache sein: %1.</translation>
    </message>
    <message>
        <source>Coordination</source>
        <translation>Koordination</translation>
    </message>
    <message>
        <source>Coordination of %1</source>
        <translation>Koordination von %1</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Vision</source>
        <translation>Kamerabilder</translation>
    </message>
    <message>
        <source>Fuzzy</source>
        <translation>Fuzzy</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>Graph</translation>
    </message>
    <message>
        <source>The new world</source>
        <translation>Die neue Welt</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved. Save them?</source>
        <translation>%1 hat Änderungen, die nicht gespeichert sind. Speichern?</translation>
    </message>
    <message>
        <source>The table of a run cannot be played</source>
        <translation>Die Tabelle eines Laufs kann nicht abgespielt werden</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has the numbers of a run, but not its world. Record the run as .mcap to open it here; Plots shows numbers while it runs.</source>
        <translation>&apos;%1&apos; hat die Zahlen eines Laufs, aber nicht seine Welt. Zeichnen Sie den Lauf als .mcap auf, um ihn hier zu öffnen; Kurven zeigt Zahlen, während er läuft.</translation>
    </message>
    <message>
        <source>The world cannot be opened</source>
        <translation>Die Welt kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Opening &apos;%1&apos;...</source>
        <translation>&apos;%1&apos; wird geöffnet...</translation>
    </message>
    <message>
        <source>The text has mistakes</source>
        <translation>Der Text hat Fehler</translation>
    </message>
    <message>
        <source>The text of the world has mistakes: %1
Save it anyway?</source>
        <translation>Der Text der Welt hat Fehler: %1
Trotzdem speichern?</translation>
    </message>
    <message>
        <source>Save the world</source>
        <translation>Welt speichern</translation>
    </message>
    <message>
        <source>Worlds (*.xml)</source>
        <translation>Welten (*.xml)</translation>
    </message>
    <message>
        <source>The file has changed</source>
        <translation>Die Datei wurde geändert</translation>
    </message>
    <message>
        <source>Another program has changed &apos;%1&apos; since it was opened. Overwrite it?</source>
        <translation>Ein anderes Programm hat &apos;%1&apos; geändert, seit es geöffnet wurde. Überschreiben?</translation>
    </message>
    <message>
        <source>The file is write-protected</source>
        <translation>Die Datei ist schreibgeschützt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is write-protected. Write it anyway? It stays write-protected.</source>
        <translation>&apos;%1&apos; ist schreibgeschützt. Trotzdem schreiben? Der Schutz bleibt.</translation>
    </message>
    <message>
        <source>Saved as &apos;%1&apos;</source>
        <translation>Gespeichert als &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>The engine does not answer: a plugin takes long. The world is saved as soon as it does. &apos;Stop the engine now&apos; in the menu Simulation starts it again; then save again.</source>
        <translation>Die Engine antwortet nicht: Ein Plugin braucht lange. Die Welt wird gespeichert, sobald sie es tut. &apos;Die Engine jetzt anhalten&apos; im Menü Simulation startet sie neu; speichern Sie dann noch einmal.</translation>
    </message>
    <message>
        <source>Another program has changed &apos;%1&apos;. Read it again? Undo leads back to your unsaved changes.</source>
        <translation>Ein anderes Programm hat &apos;%1&apos; geändert. Noch einmal lesen? Rückgängig führt zu Ihren ungespeicherten Änderungen zurück.</translation>
    </message>
    <message>
        <source>Another program has changed &apos;%1&apos;. Read it again?</source>
        <translation>Ein anderes Programm hat &apos;%1&apos; geändert. Noch einmal lesen?</translation>
    </message>
    <message>
        <source>&amp;Read again</source>
        <translation>&amp;Noch einmal lesen</translation>
    </message>
    <message>
        <source>&amp;Keep mine</source>
        <translation>Meine &amp;behalten</translation>
    </message>
    <message>
        <source>Not read</source>
        <translation>Nicht gelesen</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Ungespeicherte Arbeit</translation>
    </message>
    <message>
        <source>The unsaved work of a window that was not closed properly cannot be read. It is in &apos;%1&apos;, and stays there.</source>
        <translation>Die ungespeicherte Arbeit eines Fensters, das nicht richtig geschlossen wurde, kann nicht gelesen werden. Sie ist in &apos;%1&apos; und bleibt dort.</translation>
    </message>
    <message>
        <source>A window was not closed properly. Continue its unsaved work on %1?</source>
        <translation>Ein Fenster wurde nicht richtig geschlossen. Die ungespeicherte Arbeit an %1 fortsetzen?</translation>
    </message>
    <message>
        <source>a new world</source>
        <translation>einer neuen Welt</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Kiste</translation>
    </message>
    <message>
        <source>Add a static, dynamic or moving box, or another obstacle</source>
        <translation>Eine feste, dynamische oder bewegte Kiste oder ein anderes Hindernis hinzufügen</translation>
    </message>
    <message>
        <source>Theme: as the s&amp;ystem</source>
        <translation>Farben: wie das S&amp;ystem</translation>
    </message>
    <message>
        <source>Theme: &amp;light</source>
        <translation>Farben: &amp;hell</translation>
    </message>
    <message>
        <source>Theme: &amp;dark</source>
        <translation>Farben: &amp;dunkel</translation>
    </message>
    <message>
        <source>The next window that you open has this language.</source>
        <translation>Das nächste Fenster, das Sie öffnen, hat diese Sprache.</translation>
    </message>
    <message>
        <source>Language: as the s&amp;ystem</source>
        <translation>Sprache: wie das S&amp;ystem</translation>
    </message>
    <message>
        <source>Language: %1</source>
        <translation>Sprache: %1</translation>
    </message>
    <message>
        <source>Show the window %1</source>
        <translation>Das Fenster %1 zeigen</translation>
    </message>
    <message>
        <source>Go to %1 (%2)</source>
        <translation>Gehe zu %1 (%2)</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>set the speed</source>
        <translation>Tempo setzen</translation>
    </message>
    <message>
        <source>Set the speed to %1</source>
        <translation>Tempo auf %1 setzen</translation>
    </message>
    <message>
        <source>set the seed</source>
        <translation>Startwert setzen</translation>
    </message>
    <message>
        <source>Set the seed to %1</source>
        <translation>Startwert auf %1 setzen</translation>
    </message>
    <message>
        <source>go to the time</source>
        <translation>Zeit: gehe zu</translation>
    </message>
    <message>
        <source>Go to the time %1 s</source>
        <translation>Gehe zur Zeit %1 s</translation>
    </message>
    <message>
        <source>Reading &apos;%1&apos;...</source>
        <translation>&apos;%1&apos; wird gelesen...</translation>
    </message>
    <message>
        <source>run %1 of %2</source>
        <translation>Lauf %1 von %2</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>wie aufgezeichnet</translation>
    </message>
    <message>
        <source>not as recorded</source>
        <translation>nicht wie aufgezeichnet</translation>
    </message>
    <message>
        <source>Not the recorded run</source>
        <translation>Nicht der aufgezeichnete Lauf</translation>
    </message>
    <message>
        <source>This run ended differently from the recorded one: state hash %1, recorded %2. Another version of Elsie, other plugins or other files of the world made the recording.</source>
        <translation>Dieser Lauf endete anders als der aufgezeichnete: Zustands-Hash %1, aufgezeichnet %2. Die Aufzeichnung stammt von einer anderen Version von Elsie, anderen Plugins oder anderen Dateien der Welt.</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s: %2</translation>
    </message>
    <message>
        <source>No events yet</source>
        <translation>Noch keine Ereignisse</translation>
    </message>
    <message>
        <source>A new seed</source>
        <translation>Ein neuer Startwert</translation>
    </message>
    <message>
        <source>The run is at %1 s. A new seed starts it again, and this run is lost. Start again with seed %2?</source>
        <translation>Der Lauf ist bei %1 s. Ein neuer Startwert beginnt ihn von vorn, und dieser Lauf geht verloren. Mit Startwert %2 neu beginnen?</translation>
    </message>
    <message>
        <source>&amp;New world</source>
        <translation>&amp;Neue Welt</translation>
    </message>
    <message>
        <source>A room in which a robot collects four resources</source>
        <translation>Ein Raum, in dem ein Roboter vier Rohstoffe sammelt</translation>
    </message>
    <message>
        <source>Ne&amp;w behaviour...</source>
        <translation>Ne&amp;ues Verhalten...</translation>
    </message>
    <message>
        <source>Writes a behaviour in C++ or Python, loads it, and opens its source</source>
        <translation>Schreibt ein Verhalten in C++ oder Python, lädt es und öffnet seinen Quelltext</translation>
    </message>
    <message>
        <source>Obli&amp;quely (isometric)</source>
        <translation>Schr&amp;äg (isometrisch)</translation>
    </message>
    <message>
        <source>Follow it from &amp;behind</source>
        <translation>Ihm von hin&amp;ten folgen</translation>
    </message>
    <message>
        <source>From the robot&apos;s &amp;place</source>
        <translation>Vom Platz &amp;des Roboters aus</translation>
    </message>
    <message>
        <source>Sho&amp;w the end of the run</source>
        <translation>En&amp;de des Laufs zeigen</translation>
    </message>
    <message>
        <source>Outcome, collected, distance, collisions, state hash, and why it failed</source>
        <translation>Ausgang, Gesammeltes, Strecke, Kollisionen, Zustands-Hash und warum er gescheitert ist</translation>
    </message>
    <message>
        <source>&amp;Tutorial</source>
        <translation>T&amp;utorial</translation>
    </message>
    <message>
        <source>&amp;Page of the selection</source>
        <translation>&amp;Seite zur Auswahl</translation>
    </message>
    <message>
        <source>The page of the documentation about the selected behaviour, coordinator or sensor</source>
        <translation>Die Seite der Dokumentation über das ausgewählte Verhalten, den Koordinator oder den Sensor</translation>
    </message>
    <message>
        <source>&lt;p&gt;In the view: the left button orbits, the right one pans, the wheel zooms; a click selects, with Shift several; a right click edits. Ctrl and a button always move the camera. Dragging the selected object moves it, its handles turn and resize it; Ctrl snaps, Shift refines. Arrow keys move the selection, with Shift by 1 cm. Space runs and pauses. G moves, R turns, S resizes: then X or Y, a number (m, degrees, a factor), and Enter; or the mouse.&lt;/p&gt;&lt;p&gt;On the time line: Left and Right by 0.1 s, with Shift by 1 s; comma and period to the previous and next event; Home and End to the start and to now.&lt;/p&gt;</source>
        <translation>&lt;p&gt;In der Ansicht: Die linke Taste dreht die Ansicht, die rechte verschiebt sie, das Rad zoomt; ein Klick wählt aus, mit Umschalt mehrere; ein Rechtsklick bearbeitet. Strg und eine Taste der Maus bewegen immer die Kamera. Ziehen verschiebt das ausgewählte Ding, seine Griffe drehen es und ändern seine Größe; Strg rastet ein, Umschalt verfeinert. Pfeiltasten verschieben die Auswahl, mit Umschalt um 1 cm. Die Leertaste lässt laufen und hält an. G verschiebt, R dreht, S ändert die Größe: dann X oder Y, eine Zahl (m, Grad, ein Faktor) und Eingabe; oder die Maus.&lt;/p&gt;&lt;p&gt;Auf der Zeitleiste: Links und Rechts um 0.1 s, mit Umschalt um 1 s; Komma und Punkt zum vorigen und nächsten Ereignis; Pos1 und Ende zum Anfang und zum Jetzt.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelltext</translation>
    </message>
    <message>
        <source>The run has not ended.</source>
        <translation>Der Lauf ist nicht beendet.</translation>
    </message>
    <message>
        <source>The engine compiles and loads it...</source>
        <translation>Die Engine kompiliert und lädt es...</translation>
    </message>
    <message>
        <source>%1 is loaded. Select a robot; Behaviours gives it to the robot.</source>
        <translation>%1 ist geladen. Wählen Sie einen Roboter aus, und geben Sie es ihm unter Verhalten.</translation>
    </message>
    <message>
        <source>add %1 to %2</source>
        <translation>%1 zu %2 hinzufügen</translation>
    </message>
    <message>
        <source>%1 is loaded, and %2 has it.</source>
        <translation>%1 ist geladen, und %2 hat es.</translation>
    </message>
    <message>
        <source>Not added</source>
        <translation>Nicht hinzugefügt</translation>
    </message>
    <message>
        <source>%1 is loaded, but %2 cannot have it: %3</source>
        <translation>%1 ist geladen, aber %2 kann es nicht haben: %3</translation>
    </message>
    <message>
        <source>The source &apos;%1&apos; has changes that are not saved. Save them?</source>
        <translation>Der Quelltext &apos;%1&apos; hat Änderungen, die nicht gespeichert sind. Speichern?</translation>
    </message>
    <message>
        <source>No documentation</source>
        <translation>Keine Dokumentation</translation>
    </message>
    <message>
        <source>The pages of the documentation are not installed. They are in the folder docs of Elsie&apos;s sources; &apos;make install&apos; installs them with the program.</source>
        <translation>Die Seiten der Dokumentation sind nicht installiert. Sie sind im Ordner docs der Quellen von Elsie; &apos;make install&apos; installiert sie mit dem Programm.</translation>
    </message>
    <message>
        <source>Select a plugin, such as a behaviour or a sensor: then this opens its page. Here is the page about worlds.</source>
        <translation>Wählen Sie ein Plugin aus, zum Beispiel ein Verhalten oder einen Sensor: Dann öffnet dies seine Seite. Hier ist die Seite über Welten.</translation>
    </message>
    <message>
        <source>%1 has no page; Properties shows what its parameters mean.</source>
        <translation>%1 hat keine Seite; Eigenschaften zeigt, was die Parameter bedeuten.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>S&amp;hare as a page...</source>
        <translation>Als S&amp;eite weitergeben...</translation>
    </message>
    <message>
        <source>Writes the run as one HTML file that plays it in any browser</source>
        <translation>Schreibt den Lauf als eine HTML-Datei, die ihn in jedem Browser abspielt</translation>
    </message>
    <message>
        <source>success</source>
        <translation>Erfolg</translation>
    </message>
    <message>
        <source>failure</source>
        <translation>gescheitert</translation>
    </message>
    <message>
        <source>time is up</source>
        <translation>die Zeit ist um</translation>
    </message>
    <message>
        <source>no goals</source>
        <translation>ohne Ziele</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>The source &apos;%1&apos; is not there any more. Its unsaved text is in &apos;%2&apos;, and stays there.</source>
        <translation>Den Quelltext &apos;%1&apos; gibt es nicht mehr. Sein ungespeicherter Text ist in &apos;%2&apos; und bleibt dort.</translation>
    </message>
    <message>
        <source>This window continues the unsaved work; &apos;%1&apos; is not opened.</source>
        <translation>Dieses Fenster setzt die ungesicherte Arbeit fort; &apos;%1&apos; wird nicht geöffnet.</translation>
    </message>
    <message>
        <source>✗ Saved, but no run can use it: %1</source>
        <translation>✗ Gespeichert, aber kein Lauf kann es verwenden: %1</translation>
    </message>
    <message>
        <source>✓ Saved: the run will use it.</source>
        <translation>✓ Gespeichert: der Lauf wird es verwenden.</translation>
    </message>
    <message>
        <source>✓ Saved. This run keeps the version with which it began; the next one, after Reset (Ctrl+R), has this.</source>
        <translation>✓ Gespeichert. Dieser Lauf behält die Fassung, mit der er begonnen hat; der nächste, nach Zurücksetzen (Strg+R), hat diese.</translation>
    </message>
    <message>
        <source>%1 (not whole)</source>
        <translation>%1 (unvollständig)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not whole: its writing was cut off. It is played as far as it goes.</source>
        <translation>&apos;%1&apos; ist unvollständig: das Schreiben wurde abgebrochen. Die Aufzeichnung wird so weit abgespielt, wie sie reicht.</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::NewBehaviorDialog</name>
    <message>
        <source>New behaviour</source>
        <translation>Neues Verhalten</translation>
    </message>
    <message>
        <source>Writes a small behaviour that works, loads it, and adds it to the selected robot. You change it in the window Source; whenever you save, the robot goes on with the new one.</source>
        <translation>Schreibt ein kleines Verhalten, das funktioniert, lädt es und gibt es dem ausgewählten Roboter. Sie ändern es im Fenster Quelltext; nach jedem Speichern macht der Roboter mit dem neuen weiter.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>C++, compiled: fastest</source>
        <translation>C++, kompiliert: am schnellsten</translation>
    </message>
    <message>
        <source>Python: loaded at once</source>
        <translation>Python: sofort geladen</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation>&amp;Durchsuchen...</translation>
    </message>
    <message>
        <source>In the &amp;folder</source>
        <translation>Im &amp;Ordner</translation>
    </message>
    <message>
        <source>&amp;Write and load</source>
        <translation>Schreiben und &amp;laden</translation>
    </message>
    <message>
        <source>The folder of the new folder</source>
        <translation>Der Ordner für den neuen Ordner</translation>
    </message>
    <message>
        <source>The program &apos;%1&apos; does not start: %2</source>
        <translation>Das Programm &apos;%1&apos; startet nicht: %2</translation>
    </message>
    <message>
        <source>The behaviour needs a name: small letters, digits and underscores, such as &apos;follow_wall&apos;.</source>
        <translation>Das Verhalten braucht einen Namen: Kleinbuchstaben, Ziffern und Unterstriche, wie &apos;follow_wall&apos;.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; exists already; choose another name, or another folder.</source>
        <translation>&apos;%1&apos; gibt es schon; wählen Sie einen anderen Namen oder einen anderen Ordner.</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::PipedFilm</name>
    <message>
        <source>the program ffmpeg is not installed; &apos;sudo apt install ffmpeg&apos; installs it</source>
        <translation>das Programm ffmpeg ist nicht installiert; &apos;sudo apt install ffmpeg&apos; installiert es</translation>
    </message>
    <message>
        <source>ffmpeg ended with exit code %1</source>
        <translation>ffmpeg endete mit dem Exit-Code %1</translation>
    </message>
    <message>
        <source>ffmpeg says &apos;%1&apos;</source>
        <translation>ffmpeg meldet &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::PlotsPanel</name>
    <message>
        <source>Plot of the chosen numbers over time in s</source>
        <translation>Die gewählten Zahlen über der Zeit in s</translation>
    </message>
    <message>
        <source>Numbers to plot</source>
        <translation>Zahlen, die gezeichnet werden können</translation>
    </message>
    <message>
        <source>Space or a click on the box plots a number</source>
        <translation>Leertaste oder ein Klick auf das Kästchen zeichnet eine Zahl</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Speichern...</translation>
    </message>
    <message>
        <source>Save the plot as PNG or SVG, or its numbers as CSV: the samples of the run at equal times, whatever its speed. A long run keeps fewer of them.</source>
        <translation>Die Kurven als PNG oder SVG speichern, oder ihre Zahlen als CSV: die Werte des Laufs zu gleichen Zeitabständen, bei jedem Tempo. Ein langer Lauf behält weniger davon.</translation>
    </message>
    <message>
        <source>Save plot: %1</source>
        <translation>Kurven speichern: %1</translation>
    </message>
    <message>
        <source>Pictures or tables (*.png *.svg *.csv)</source>
        <translation>Bilder oder Tabellen (*.png *.svg *.csv)</translation>
    </message>
    <message>
        <source>Save plot</source>
        <translation>Kurven speichern</translation>
    </message>
    <message>
        <source>The plot was not saved as &apos;%1&apos;: %2</source>
        <translation>Die Kurven wurden nicht als &apos;%1&apos; gespeichert: %2</translation>
    </message>
    <message>
        <source>%1, in %2</source>
        <translation>%1, in %2</translation>
    </message>
    <message>
        <source>Choose numbers to plot them</source>
        <translation>Wählen Sie Zahlen, um sie zu zeichnen</translation>
    </message>
    <message>
        <source>%1 samples, up to %2 s apart</source>
        <translation>%1 Werte, bis zu %2 s auseinander</translation>
    </message>
    <message>
        <source>No number is chosen. Check the numbers to save in the tree.</source>
        <translation>Es ist keine Zahl gewählt. Wählen Sie im Baum die Zahlen, die gespeichert werden sollen.</translation>
    </message>
    <message>
        <source>The name must end in .png, .svg or .csv.</source>
        <translation>Der Name muss auf .png, .svg oder .csv enden.</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>least</source>
        <translation>kleinster</translation>
    </message>
    <message>
        <source>most</source>
        <translation>größter</translation>
    </message>
    <message>
        <source>from [s]</source>
        <translation>von [s]</translation>
    </message>
    <message>
        <source>to [s]</source>
        <translation>bis [s]</translation>
    </message>
    <message>
        <source>at %1 s</source>
        <translation>bei %1 s</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::ProblemsPanel</name>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Enter or a double click goes to the line; F8 goes to the next problem</source>
        <translation>Eingabe oder ein Doppelklick führt zur Zeile; F8 führt zum nächsten Problem</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>Warnung: %1</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::Properties</name>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter of the properties</source>
        <translation>Filter der Eigenschaften</translation>
    </message>
    <message>
        <source>set %1 of %2</source>
        <translation>%1 von %2 setzen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>one element</source>
        <translation>ein Element</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 Elemente</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Behaviours...</source>
        <translation>Verhalten...</translation>
    </message>
    <message>
        <source>Coordinator...</source>
        <translation>Koordinator...</translation>
    </message>
    <message>
        <source>Add %1...</source>
        <translation>%1 hinzufügen...</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Nichts ist ausgewählt</translation>
    </message>
    <message>
        <source>No world</source>
        <translation>Keine Welt</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>at %1 s: %2 %3</source>
        <translation>bei %1 s: %2 %3</translation>
    </message>
    <message>
        <source>now at %1 s: %2 %3</source>
        <translation>jetzt bei %1 s: %2 %3</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::RunCard</name>
    <message>
        <source>Collected</source>
        <translation>Gesammelt</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Kollisionen</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies the state hash: two runs with the same hash are the same run</source>
        <translation>Kopiert den Zustands-Hash: Zwei Läufe mit demselben Hash sind derselbe Lauf</translation>
    </message>
    <message>
        <source>State hash</source>
        <translation>Zustands-Hash</translation>
    </message>
    <message>
        <source>Run &amp;again</source>
        <translation>&amp;Noch einmal laufen</translation>
    </message>
    <message>
        <source>The same run again: the same world and seed</source>
        <translation>Derselbe Lauf noch einmal: dieselbe Welt und derselbe Startwert</translation>
    </message>
    <message>
        <source>Ne&amp;xt seed</source>
        <translation>Nä&amp;chster Startwert</translation>
    </message>
    <message>
        <source>The same world with other random numbers</source>
        <translation>Dieselbe Welt mit anderen Zufallszahlen</translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation>Kopiert: %1</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>The end of the run: %1</source>
        <translation>Das Ende des Laufs: %1</translation>
    </message>
    <message>
        <source>Collected: %1, distance: %2, collisions: %3, state hash: %4</source>
        <translation>Gesammelt: %1, Strecke: %2, Kollisionen: %3, Zustands-Hash: %4</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::RunReader</name>
    <message>
        <source>&apos;%1&apos; does not start: %2</source>
        <translation>&apos;%1&apos; startet nicht: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; did not report what it read from the recording. Install it and this window again, from the same version.</source>
        <translation>&apos;%1&apos; hat nicht gemeldet, was es aus der Aufzeichnung gelesen hat. Installieren Sie es und dieses Fenster neu, in derselben Version.</translation>
    </message>
    <message>
        <source>There are no runs in this database.</source>
        <translation>In dieser Datenbank sind keine Läufe.</translation>
    </message>
    <message>
        <source>Open a run</source>
        <translation>Einen Lauf öffnen</translation>
    </message>
    <message>
        <source>Runs of the database</source>
        <translation>Läufe der Datenbank</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ausgang</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::SceneView</name>
    <message>
        <source>World</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>The world from the camera. All objects are also in the tree, with their places as numbers.</source>
        <translation>Die Welt aus der Kamera. Alle Dinge stehen mit ihren Orten als Zahlen auch im Baum.</translation>
    </message>
    <message>
        <source>%1   (Enter: apply, Esc: cancel)</source>
        <translation>%1   (Eingabe: anwenden, Esc: abbrechen)</translation>
    </message>
    <message>
        <source>%1 parts of sketches are not drawn: there are too many</source>
        <translation>%1 Teile von Skizzen sind nicht gezeichnet: Es sind zu viele</translation>
    </message>
    <message>
        <source>%1 m, %2°</source>
        <translation>%1 m, %2°</translation>
    </message>
    <message>
        <source>The view cannot resize this; its numbers are in Properties.</source>
        <translation>Die Ansicht kann die Größe hiervon nicht ändern; die Zahlen stehen in den Eigenschaften.</translation>
    </message>
    <message>
        <source>Looking back at %1 s: places only; sketches, fields and lights are not stored</source>
        <translation>Rückblick auf %1 s: nur Orte; Skizzen, Felder und Lichter sind nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::SensorsPanel</name>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter of the sensors</source>
        <translation>Filter der Sensoren</translation>
    </message>
    <message>
        <source>Sensors and their readings</source>
        <translation>Sensoren und ihre Messwerte</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Messwert</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>heard</source>
        <translation>gehört</translation>
    </message>
    <message>
        <source>heard from %1</source>
        <translation>gehört von %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>messages</source>
        <translation>Nachrichten</translation>
    </message>
    <message>
        <source>not stored</source>
        <translation>nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::Sharer</name>
    <message>
        <source>A page is being written already.</source>
        <translation>Es wird schon eine Seite geschrieben.</translation>
    </message>
    <message>
        <source>There is no run to show: run the world first.</source>
        <translation>Es gibt keinen Lauf zu zeigen: Lassen Sie zuerst die Welt laufen.</translation>
    </message>
    <message>
        <source>Share the run as a page</source>
        <translation>Den Lauf als Seite weitergeben</translation>
    </message>
    <message>
        <source>Pages (*.html)</source>
        <translation>Seiten (*.html)</translation>
    </message>
    <message>
        <source>there is no room for temporary files: %1</source>
        <translation>für vorübergehende Dateien ist kein Platz: %1</translation>
    </message>
    <message>
        <source>Writing &apos;%1&apos;</source>
        <translation>&apos;%1&apos; wird geschrieben</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>the engine does not say how the run began</source>
        <translation>die Engine sagt nicht, wie der Lauf begann</translation>
    </message>
    <message>
        <source>&apos;%1&apos; ended without a message</source>
        <translation>&apos;%1&apos; endete ohne eine Meldung</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not start: %2</source>
        <translation>&apos;%1&apos; startet nicht: %2</translation>
    </message>
    <message>
        <source>The page is written</source>
        <translation>Die Seite ist geschrieben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes %2 MB. It plays the run in any browser, without Elsie and without a network.</source>
        <translation>&apos;%1&apos; braucht %2 MB. Die Seite spielt den Lauf in jedem Browser, ohne Elsie und ohne Netz.</translation>
    </message>
    <message>
        <source>&amp;Open in the browser</source>
        <translation>Im Browser ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Not opened</source>
        <translation>Nicht geöffnet</translation>
    </message>
    <message>
        <source>No browser opens &apos;%1&apos;. Open it from your browser or file manager.</source>
        <translation>Kein Browser öffnet &apos;%1&apos;. Öffnen Sie die Datei in Ihrem Browser oder Ihrer Dateiverwaltung.</translation>
    </message>
    <message>
        <source>The page is in &apos;%1&apos;</source>
        <translation>Die Seite ist in &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Not shared</source>
        <translation>Nicht weitergegeben</translation>
    </message>
    <message>
        <source>The page could not be written to &apos;%1&apos;: %2
What was there before is unchanged.</source>
        <translation>Die Seite konnte nicht nach &apos;%1&apos; geschrieben werden: %2
Was vorher dort war, ist unverändert.</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::ShortcutsDialog</name>
    <message>
        <source>Keys of the commands</source>
        <translation>Tasten der Befehle</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter of the commands</source>
        <translation>Filter der Befehle</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>Key of %1</source>
        <translation>Taste von %1</translation>
    </message>
    <message>
        <source>%1 is the key of &apos;%2&apos; and of &apos;%3&apos;. Remove it from one of them.</source>
        <translation>%1 ist die Taste von &apos;%2&apos; und von &apos;%3&apos;. Entfernen Sie sie bei einem davon.</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::SourceEditor</name>
    <message>
        <source>&amp;Save and load</source>
        <translation>Speichern und &amp;laden</translation>
    </message>
    <message>
        <source>Source of the plugin</source>
        <translation>Quelltext des Plugins</translation>
    </message>
    <message>
        <source>Saves the file; the engine compiles and loads it, and the run goes on (Ctrl+S)</source>
        <translation>Speichert die Datei; die Engine kompiliert und lädt sie, und der Lauf geht weiter (Strg+S)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read: %2.</source>
        <translation>&apos;%1&apos; kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>it is too long for a source</source>
        <translation>sie ist zu lang für einen Quelltext</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not in UTF-8, and saving it here would damage it. Convert it first, for example with &apos;iconv -f LATIN1 -t UTF-8&apos;.</source>
        <translation>&apos;%1&apos; ist nicht in UTF-8, und hier zu speichern würde sie beschädigen. Wandeln Sie sie erst um, zum Beispiel mit &apos;iconv -f LATIN1 -t UTF-8&apos;.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has been changed by another program, and is not overwritten. Save again to replace it by the text in this window.</source>
        <translation>&apos;%1&apos; ist von einem anderen Programm geändert worden und wird nicht überschrieben. Speichern Sie noch einmal, um sie durch den Text in diesem Fenster zu ersetzen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be written: %2. The text stays here; make room, or allow writing there, and save again.</source>
        <translation>&apos;%1&apos; kann nicht geschrieben werden: %2. Der Text bleibt hier; schaffen Sie Platz, oder erlauben Sie dort das Schreiben, und speichern Sie noch einmal.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Saves the file (Ctrl+S)</source>
        <translation>Speichert die Datei (Strg+S)</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::SourcesPanel</name>
    <message>
        <source>Saved.</source>
        <translation>Gespeichert.</translation>
    </message>
    <message>
        <source>Saved. The engine loads it...</source>
        <translation>Gespeichert. Die Engine lädt es...</translation>
    </message>
    <message>
        <source>✓ Loaded: the engine uses what was saved.</source>
        <translation>✓ Geladen: Die Engine verwendet, was gespeichert wurde.</translation>
    </message>
    <message>
        <source>✗ Not loaded: it has errors, which the window Errors lists.</source>
        <translation>✗ Nicht geladen: Es hat Fehler, die das Fenster Fehler auflistet.</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::StartPage</name>
    <message>
        <source>Elsie</source>
        <translation>Elsie</translation>
    </message>
    <message>
        <source>Behaviour-based robots: small behaviours side by side, and a coordinator that decides.</source>
        <translation>Verhaltensbasierte Roboter: kleine Verhalten nebeneinander und ein Koordinator, der entscheidet.</translation>
    </message>
    <message>
        <source>E&amp;mpty world</source>
        <translation>&amp;Leere Welt</translation>
    </message>
    <message>
        <source>Four walls, 5 m by 5 m, and nothing in them</source>
        <translation>Vier Wände, 5 m mal 5 m, und nichts darin</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>Ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>E&amp;xamples</source>
        <translation>&amp;Beispiele</translation>
    </message>
    <message>
        <source>Recent&amp;ly opened</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;New world</source>
        <translation>&amp;Neue Welt</translation>
    </message>
    <message>
        <source>A room in which a robot collects four resources</source>
        <translation>Ein Raum, in dem ein Roboter vier Rohstoffe sammelt</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::StuckNotice</name>
    <message>
        <source>Selects the robot, so that the windows show its behaviours</source>
        <translation>Wählt den Roboter aus, sodass die Fenster seine Verhalten zeigen</translation>
    </message>
    <message>
        <source>Select %1</source>
        <translation>%1 auswählen</translation>
    </message>
    <message>
        <source>Other robots: %1.</source>
        <translation>Andere Roboter: %1.</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::TimeLine</name>
    <message>
        <source>Time of the run</source>
        <translation>Zeit des Laufs</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Back to the present (End)</source>
        <translation>Zurück zur Gegenwart (Ende)</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 von %2 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s: %2</translation>
    </message>
    <message>
        <source>%1, in the recording</source>
        <translation>%1, in der Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::Trainer</name>
    <message>
        <source>&apos;%1&apos; does not start: %2</source>
        <translation>&apos;%1&apos; startet nicht: %2</translation>
    </message>
    <message>
        <source>The training ended without a message.</source>
        <translation>Das Training endete ohne eine Meldung.</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::TrainingPage</name>
    <message>
        <source>Hidden &amp;layers</source>
        <translation>Verdeckte &amp;Schichten</translation>
    </message>
    <message>
        <source>Their sizes</source>
        <translation>Ihre Größen</translation>
    </message>
    <message>
        <source>&amp;Train with OK, and use the weights</source>
        <translation>Mit OK &amp;trainieren und die Gewichte verwenden</translation>
    </message>
    <message>
        <source>The weights are written next to the world, which has no file of its own yet: save it first.</source>
        <translation>Die Gewichte werden neben die Welt geschrieben, die noch keine eigene Datei hat: Speichern Sie sie zuerst.</translation>
    </message>
    <message>
        <source>%1 of %2 samples, mean error %3</source>
        <translation>%1 von %2 Beispielen, mittlerer Fehler %3</translation>
    </message>
    <message>
        <source>Mean error %1 after %2 samples.</source>
        <translation>Mittlerer Fehler %1 nach %2 Beispielen.</translation>
    </message>
    <message>
        <source>The network is loaded. %1</source>
        <translation>Das Netz ist geladen. %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Inputs: %1 (%2)
Outputs: %3 (%4)</source>
        <translation>Eingänge: %1 (%2)
Ausgänge: %3 (%4)</translation>
    </message>
    <message>
        <source>Neurons in hidden layer %1</source>
        <translation>Neuronen in der verdeckten Schicht %1</translation>
    </message>
    <message>
        <source>Trains the network that a run with this seed would train, and writes its weights to a file next to the world. Otherwise each run trains its own network.</source>
        <translation>Trainiert das Netz, das ein Lauf mit diesem Startwert trainieren würde, und schreibt seine Gewichte in eine Datei neben der Welt. Sonst trainiert jeder Lauf sein eigenes Netz.</translation>
    </message>
    <message>
        <source>Training...</source>
        <translation>Das Training läuft...</translation>
    </message>
    <message>
        <source>Stopped: nothing was written.</source>
        <translation>Angehalten: Es wurde nichts geschrieben.</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::TypedDrag</name>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>x and y</source>
        <translation>x und y</translation>
    </message>
    <message>
        <source>move along %1 by %2 m</source>
        <translation>entlang %1 um %2 m verschieben</translation>
    </message>
    <message>
        <source>turn by %1°</source>
        <translation>um %1° drehen</translation>
    </message>
    <message>
        <source>size along %1 times %2</source>
        <translation>Größe entlang %1 mal %2</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::VisionPanel</name>
    <message>
        <source>Pictures of the cameras</source>
        <translation>Bilder der Kameras</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Choose the pictures that show</source>
        <translation>Die Bilder wählen, die gezeigt werden</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>width [px]</source>
        <translation>Breite [px]</translation>
    </message>
    <message>
        <source>height [px]</source>
        <translation>Höhe [px]</translation>
    </message>
    <message>
        <source>mean colour</source>
        <translation>mittlere Farbe</translation>
    </message>
    <message>
        <source>No camera has seen anything yet</source>
        <translation>Noch hat keine Kamera etwas gesehen</translation>
    </message>
    <message>
        <source>No picture is chosen</source>
        <translation>Es ist kein Bild gewählt</translation>
    </message>
    <message>
        <source>Save picture...</source>
        <translation>Bild speichern...</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>The pictures of %1 s are not stored: they are while this window is shown</source>
        <translation>Die Bilder von %1 s sind nicht gespeichert: Sie werden es nur, solange dieses Fenster zu sehen ist</translation>
    </message>
    <message>
        <source>not stored</source>
        <translation>nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::Workbench</name>
    <message>
        <source>And %1 more.</source>
        <translation>Und %1 weitere.</translation>
    </message>
    <message>
        <source>No plugin was active.</source>
        <translation>Kein Plugin war aktiv.</translation>
    </message>
    <message>
        <source>It was killed from outside, for example for lack of memory.</source>
        <translation>Sie wurde von außen beendet, zum Beispiel aus Mangel an Speicher.</translation>
    </message>
    <message>
        <source>The engine ended with exit code %1.</source>
        <translation>Die Engine endete mit dem Exit-Code %1.</translation>
    </message>
    <message>
        <source>The engine ended before this was done: %1</source>
        <translation>Die Engine endete, bevor dies getan war: %1</translation>
    </message>
    <message>
        <source>The engine ends as soon as it starts: %1</source>
        <translation>Die Engine endet, sobald sie startet: %1</translation>
    </message>
    <message>
        <source>You stopped the engine while it read this world: %1</source>
        <translation>Sie haben die Engine angehalten, während sie diese Welt las: %1</translation>
    </message>
    <message>
        <source>The engine ended when it read this world: %1</source>
        <translation>Die Engine endete, als sie diese Welt las: %1</translation>
    </message>
    <message>
        <source>The engine ended %1 times with this world, which is not opened again until you change it: %2</source>
        <translation>Die Engine endete %1-mal mit dieser Welt, die nicht wieder geöffnet wird, bis Sie sie ändern: %2</translation>
    </message>
    <message>
        <source>type</source>
        <translation>tippen</translation>
    </message>
    <message>
        <source>There is no engine: it could not be started.</source>
        <translation>Es gibt keine Engine: Sie konnte nicht gestartet werden.</translation>
    </message>
    <message>
        <source>The text of the world has mistakes; fix them first, or undo what was typed.</source>
        <translation>Der Text der Welt hat Fehler; beheben Sie sie zuerst, oder nehmen Sie das Getippte zurück.</translation>
    </message>
    <message>
        <source>Another world was opened before this was done.</source>
        <translation>Eine andere Welt wurde geöffnet, bevor dies getan war.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a folder, a device or a pipe; expected the file of a world.</source>
        <translation>&apos;%1&apos; ist ein Ordner, ein Gerät oder eine Pipe; erwartet wird die Datei einer Welt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has more than %2 MB, too large for the window; use `elsie run` instead.</source>
        <translation>&apos;%1&apos; hat mehr als %2 MB, zu viel für das Fenster; verwenden Sie stattdessen `elsie run`.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read: %2</source>
        <translation>&apos;%1&apos; kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not UTF-8 text: line %2 has other bytes. Convert it first, for example with: iconv -f latin1 -t utf-8</source>
        <translation>&apos;%1&apos; ist kein UTF-8-Text: Zeile %2 hat andere Bytes. Wandeln Sie sie zuerst um, zum Beispiel mit: iconv -f latin1 -t utf-8</translation>
    </message>
    <message>
        <source>read the file again</source>
        <translation>Datei noch einmal lesen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not on disk any more: another program has deleted, renamed or moved it. The world is unsaved until you save it.</source>
        <translation>&apos;%1&apos; ist nicht mehr auf der Platte: Ein anderes Programm hat die Datei gelöscht, umbenannt oder verschoben. Die Welt gilt als ungespeichert, bis Sie sie speichern.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is on disk again.</source>
        <translation>&apos;%1&apos; ist wieder auf der Platte.</translation>
    </message>
    <message>
        <source>The world could not be saved as &apos;%1&apos;: %2. What was there before is unchanged.</source>
        <translation>Die Welt konnte nicht als &apos;%1&apos; gespeichert werden: %2. Was dort stand, ist unverändert.</translation>
    </message>
    <message>
        <source>Unsaved work cannot be kept for the case of a crash: your data folder is full or read-only. Save the world.</source>
        <translation>Ungespeicherte Arbeit kann nicht für den Fall eines Absturzes bewahrt werden: Ihr Datenordner ist voll oder schreibgeschützt. Speichern Sie die Welt.</translation>
    </message>
    <message>
        <source>enter what was typed</source>
        <translation>Getipptes übernehmen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was typed for %2 and is not entered: %3</source>
        <translation>&apos;%1&apos; wurde für %2 getippt und ist nicht übernommen: %3</translation>
    </message>
    <message>
        <source>The world could not be saved as &apos;%1&apos;: there is no folder &apos;%2&apos;. &apos;Save as...&apos; saves it elsewhere.</source>
        <translation>Die Welt konnte nicht als &apos;%1&apos; gespeichert werden: den Ordner &apos;%2&apos; gibt es nicht. &apos;Speichern unter...&apos; speichert sie anderswo.</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::WorldEditor</name>
    <message>
        <source>Text of the world</source>
        <translation>Text der Welt</translation>
    </message>
</context>
<context>
    <name>elsie::desktop::WorldTree</name>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter of the tree</source>
        <translation>Filter des Baums</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>Team %1</source>
        <translation>Team %1</translation>
    </message>
    <message>
        <source>Robot...</source>
        <translation>Roboter...</translation>
    </message>
    <message>
        <source>Add a robot to the team</source>
        <translation>Dem Team einen Roboter hinzufügen</translation>
    </message>
    <message>
        <source>Sensor...</source>
        <translation>Sensor...</translation>
    </message>
    <message>
        <source>Add a sensor of any kind to the selected robot</source>
        <translation>Dem ausgewählten Roboter einen Sensor irgendeiner Art hinzufügen</translation>
    </message>
    <message>
        <source>Behaviours...</source>
        <translation>Verhalten...</translation>
    </message>
    <message>
        <source>Choose the behaviours of the selected robot</source>
        <translation>Die Verhalten des ausgewählten Roboters wählen</translation>
    </message>
    <message>
        <source>Coordinator...</source>
        <translation>Koordinator...</translation>
    </message>
    <message>
        <source>Choose or edit the coordinator of the selected robot</source>
        <translation>Den Koordinator des ausgewählten Roboters wählen oder bearbeiten</translation>
    </message>
    <message>
        <source>Locked against the mouse (Ctrl+L).</source>
        <translation>Gegen die Maus gesperrt (Strg+L).</translation>
    </message>
    <message>
        <source>It comes from the robot&apos;s template; changes made here are written into the robot&apos;s own element.</source>
        <translation>Es stammt aus der Vorlage des Roboters; Änderungen hier werden in das eigene Element des Roboters geschrieben.</translation>
    </message>
    <message>
        <source>weight %1</source>
        <translation>Gewicht %1</translation>
    </message>
</context>
</TS>
