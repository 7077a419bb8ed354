#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# What gnuplot 5.4.4 (Debian 12: 5.4.4+dfsg1-2+b2) does on a machine without fonts, as many containers
# are, and after `reset`:
#
#     pngcairo and pdfcairo draw no text at all: exit code 0, no word on the standard error
#     `reset` leaves `set linetype`, `set encoding` and `set decimalsign` as ~/.gnuplot has set them;
#     `set colorsequence default` resets the colors of linetypes, not their widths
#
# Needs what gnuplot-nox depends on.
#
# Expected: an error or a warning where no font is found, and `reset` as after a start without ~/.gnuplot.
# Found: neither.
# Versions: gnuplot-nox 5.4.4+dfsg1-2+b2. Source: Debian 12. Date: 2026-11-27. As recorded below.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
fetch gnuplot-nox=5.4.4+dfsg1-2+b2
gnuplot=usr/bin/gnuplot-nox
needs_all "$gnuplot"

echo '<fontconfig><dir>/nonexistent</dir></fontconfig>' > fonts.conf
cat > title.gp << 'END'
set terminal pngcairo size 200,100
unset border
unset tics
unset key
set output 'without.png'
plot [0:1] [0:1] 2
set output 'with.png'
set title 'A title'
replot
END
FONTCONFIG_FILE=$folder/fonts.conf "$gnuplot" --default-settings title.gp 2> errors
[ ! -s errors ] || changed "it says $(cat errors)"
cmp without.png with.png || changed "there is text"
echo "without fonts: the same picture with and without a title"

cat > reset.gp << 'END'
set linetype 1 linewidth 5
set encoding iso_8859_1
set decimalsign ','
reset
set colorsequence default
show linetype 1
show encoding
show decimalsign
END
"$gnuplot" --default-settings reset.gp 2> settings
for left in 'linewidth 5' iso_8859_1 'output is ,'; do
    grep -q "$left" settings || changed "reset undoes $left"
done
echo "after reset: linetype, encoding and decimalsign stay"
echo "as found"
