# Draws accuracy_oscillator.png: gnuplot accuracy_oscillator.gp
set encoding utf8
set terminal pngcairo enhanced font 'DejaVu Sans,11' fontscale 2.6 linewidth 3 pointscale 3.4 dashlength 0.7 size 1360,1020 background '#FFFFFF'
mark = 1
set output 'accuracy_oscillator.png'
set minussign
set format '%h'
set border 3 lw 0.7 lc rgb '#808080'
set tics out nomirror scale 0.6 textcolor rgb '#000000'
set key noautotitle noopaque
$dopri5 << EOD
8.7726387e-06 0.000626006964
1.41484556e-05 2.15594859e-06
2.47809659e-05 2.48225334e-08
4.75236067e-05 2.77083245e-10
0.00011155129 3.10649284e-11
EOD
$exact << EOD
2.409557e-06 1.56319402e-13
EOD
$fehlberg78 << EOD
1.28567702e-05 4.1445828e-05
1.58904215e-05 1.99214639e-07
1.82668628e-05 2.32668995e-10
2.40860006e-05 5.20827825e-12
3.38051909e-05 7.17648163e-13
EOD
$rk4 << EOD
5.86907235e-06 0.000396538973
1.2361137e-05 1.16970214e-06
3.5458829e-05 4.56556393e-09
0.000115893387 1.79340987e-11
0.000419581141 4.86011231e-12
0.00171791009 2.43005616e-12
0.00701212595 1.53832502e-12
0.031817964 5.28999067e-11
EOD
$front << EOD
2.409557e-06 1.56319402e-13
EOD
$allowed << EOD
1e-06 2.24399475e-10
0.1 2.24399475e-10
EOD
set lmargin at screen 0.18
set rmargin at screen 0.96
set bmargin at screen 0.28
set tmargin at screen 0.96
set key at screen 0.57, screen 0.01 center bottom horizontal maxcols 2 Left reverse samplen 2 font ',9'
set logscale xy
set format xy '10^{%L}'
set xrange [1e-06:0.1]
set yrange [1e-13:0.001]
set xlabel 'computing time per forcing period (s)'
set label 'largest error of an impact time (s)' at screen 0.03, graph 0.5 center rotate
plot $dopri5 using 1:2 with linespoints lw 1.5 pt 9 ps 1.3*mark lc rgb '#009E73' title 'dopri5', \
     $exact using 1:2 with linespoints lw 1.5 pt 7 ps 1.3*mark lc rgb '#D55E00' title 'exact', \
     $fehlberg78 using 1:2 with linespoints lw 1.5 pt 13 ps 1.3*mark lc rgb '#CC79A7' title 'fehlberg78', \
     $rk4 using 1:2 with linespoints lw 1.5 pt 5 ps 1.3*mark lc rgb '#0072B2' title 'rk4', \
     $front using 1:2 with points pt 6 ps 1.9*mark lw 1.5 lc rgb '#000000' title 'beaten by none', \
     $allowed using 1:2 with lines dt (8,4) lc rgb '#999999' title 'solver.tolerance', \
     NaN notitle
