{{! SPDX-License-Identifier: GPL-3.0-or-later }}
ink = '#222222'
set border 3 lw 1 lc rgb ink
set tics nomirror out scale 0.6 textcolor rgb ink
set grid xtics ytics lc rgb '#e3e3e3' lw 0.7 dt 1
set style fill transparent solid 0.16 noborder
set bars 0.5
set pointsize 0.7
unset key
