% Drives to where the light comes from: the mean direction of all cells, weighted by what they read.
cells = 24;
azimuth = pi - (2 * (1:cells)' - 1) * pi / cells;  % from left to right, all around

do
  now = jsondecode (input ("", "s"));  % fgetl() would wait for the beginning of the next line
  answer = struct ();
  if isfield (now, "time")
    towards = sum (now.readings.cells.values .* exp (1i * azimuth));
    if abs (towards) < 1e-9
      answer.turn = 1;  % dark: it looks around
    else
      turn = arg (towards);
      answer.forward = 0.25 * max (0, cos (turn));
      answer.turn = 3 * turn;
    end
  end
  printf ("%s\n", jsonencode (answer));
  fflush (stdout);
until isfield (now, "xEnd")  % "end", which is a word of Octave
