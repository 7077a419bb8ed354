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
# Needs gnuplot-nox. Fails when the behavior changes.
#
# Expected: an error or a warning where no font is found, and `reset` as after a start without ~/.gnuplot.
# Found: neither.
# Versions: gnuplot-nox 5.4.4+dfsg1-2+b2. Source: Debian 12. Date: 2026-11-27. As recorded below.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
dpkg-query -W -f='${Package} ${Version}\n' gnuplot-nox

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
FONTCONFIG_FILE=$folder/fonts.conf gnuplot --default-settings title.gp 2> errors
[ ! -s errors ] || { cat errors; echo changed; exit 1; }
cmp without.png with.png || { echo changed; exit 1; }
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
gnuplot --default-settings reset.gp 2> settings
for left in 'linewidth 5' iso_8859_1 'output is ,'; do
    grep -q "$left" settings || { cat settings; echo "changed: $left"; exit 1; }
done
echo "after reset: linetype, encoding and decimalsign stay"
echo "as found"
