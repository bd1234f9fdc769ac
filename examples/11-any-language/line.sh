#!/bin/sh
# Follows a dark line: turns to the side whose ground sensor sees it, and back to where it was last when none does.

# Sets $number to what the sensor $1 says of its field $2.
look() {
  number=${line#*\"$1\":\{}
  number=${number#*\"$2\":}
  number=${number%%[,\}]*}
}

last=left
while read -r line; do
  case $line in
    *'"time":'*) ;;
    *) echo '{}'; continue ;;
  esac
  look left grey; left=$number
  look middle grey; middle=$number
  look right grey; right=$number
  case $left$middle$right in
    0.01.01.0 | 0.00.01.0) last=left; echo '{"forward":0.1,"turn":2}' ;;
    1.01.00.0 | 1.00.00.0) last=right; echo '{"forward":0.1,"turn":-2}' ;;
    1.01.01.0) [ $last = left ] && echo '{"turn":2}' || echo '{"turn":-2}' ;;
    *) echo '{"forward":0.2}' ;;
  esac
done
