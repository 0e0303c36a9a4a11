# Draws accuracy_beam.png: gnuplot accuracy_beam.gp
set encoding utf8
set terminal pngcairo enhanced font 'DejaVu Sans,11' fontscale 2.6 linewidth 3 pointscale 3.4 dashlength 0.7 size 1360,1020 background '#FFFFFF'
mark = 1
set output 'accuracy_beam.png'
set minussign
set format '%h'
set border 3 lw 0.7 lc rgb '#808080'
set tics out nomirror scale 0.6 textcolor rgb '#000000'
set key noautotitle noopaque
$dopri5 << EOD
0.000580916928 1.59597193e-05
0.00141678627 6.94158571e-07
0.0025249026 9.29024901e-09
0.00889980494 1.85726989e-11
EOD
$exact << EOD
5.85052019e-06 5.19584376e-14
EOD
$fehlberg78 << EOD
0.000329784889 8.91628531e-05
0.00059715012 9.46960009e-07
0.00104857395 9.5921302e-09
0.00130454866 8.40625347e-11
EOD
$rk4 << EOD
0.000169330255 0.00160973761
0.000691895777 7.72859682e-06
0.00305096027 3.16124718e-08
0.0117498811 4.98330266e-11
0.0471911048 3.3432368e-11
0.21805016 1.76004544e-10
EOD
$front << EOD
5.85052019e-06 5.19584376e-14
EOD
$allowed << EOD
1e-06 2.22020682e-11
1 2.22020682e-11
EOD
set lmargin at screen 0.18
set rmargin at screen 0.96
set bmargin at screen 0.28
set tmargin at screen 0.96
set key at screen 0.57, screen 0.01 center bottom horizontal maxcols 2 Left reverse samplen 2 font ',9'
set logscale xy
set format xy '10^{%L}'
set xrange [1e-06:1]
set yrange [1e-14:0.01]
set xlabel 'computing time per forcing period (s)'
set label 'largest error of an impact time (s)' at screen 0.03, graph 0.5 center rotate
plot $dopri5 using 1:2 with linespoints lw 1.5 pt 9 ps 1.3*mark lc rgb '#009E73' title 'dopri5', \
     $exact using 1:2 with linespoints lw 1.5 pt 7 ps 1.3*mark lc rgb '#D55E00' title 'exact', \
     $fehlberg78 using 1:2 with linespoints lw 1.5 pt 13 ps 1.3*mark lc rgb '#CC79A7' title 'fehlberg78', \
     $rk4 using 1:2 with linespoints lw 1.5 pt 5 ps 1.3*mark lc rgb '#0072B2' title 'rk4', \
     $front using 1:2 with points pt 6 ps 1.9*mark lw 1.5 lc rgb '#000000' title 'beaten by none', \
     $allowed using 1:2 with lines dt (8,4) lc rgb '#999999' title 'solver.tolerance', \
     NaN notitle
