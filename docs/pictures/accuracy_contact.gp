# Draws accuracy_contact.svg: gnuplot accuracy_contact.gp
set encoding utf8
set terminal svg enhanced font 'DejaVu Sans,11' fontscale 1.4 linewidth 1.4 dashlength 0.7 size 640,944 background '#FFFFFF'
mark = 1.6
set output 'accuracy_contact.svg'
set minussign
set format '%h'
set border 3 lw 0.7 lc rgb '#808080'
set tics out nomirror scale 0.6 textcolor rgb '#000000'
set key noautotitle noopaque
set multiplot
$dopri5 << EOD
0.0007549 1.64657757e-05
0.00079145 1.75663355e-09
0.0010079 9.52221114e-11
0.0015409 6.89449366e-12
0.0027321 7.24021537e-14
0.00557845 7.61543606e-16
0.0124072 1e-17
EOD
$exact << EOD
0.0051807 2.28983499e-16
EOD
$fehlberg78 << EOD
0.00169765 1.44541944e-09
0.0016195 5.09762474e-10
0.00171015 1.73334676e-10
0.0018921 1.7897548e-11
0.0022001 1.74170418e-11
0.00286585 1.64419346e-12
0.0039634 1.74769921e-13
EOD
$rk4 << EOD
0.00076645 8.84347508e-05
0.00112915 8.84347508e-05
0.0007659 8.84347508e-05
0.0016506 1.45019211e-06
0.00312685 9.29559732e-09
0.00922775 1.10551273e-10
0.0338352 2.69604825e-12
0.1234421 9.39439498e-14
0.4931182 7.81128634e-14
1.917368 1.59759359e-13
7.6039905 2.80256721e-13
30.4013643 4.10423431e-12
EOD
$front << EOD
0.0007549 1.64657757e-05
0.00079145 1.75663355e-09
0.0010079 9.52221114e-11
0.0015409 6.89449366e-12
0.0027321 7.24021537e-14
0.0051807 2.28983499e-16
0.0124072 1e-17
EOD
$allowed << EOD
0.0001 1e-10
100 1e-10
EOD
set lmargin at screen 0.18
set rmargin at screen 0.96
set bmargin at screen 0.6339
set tmargin at screen 0.9797
set key at screen 0.57, screen 0.01 center bottom horizontal maxcols 2 Left reverse samplen 2 font ',9'
set key at screen 0.57, screen 0.4966
set logscale xy
set format xy '10^{%L}'
set xrange [0.0001:100]
set yrange [1e-17:0.0001]
set xlabel 'computing time per second of motion (s)'
set label 'largest error of the time of a contact (s)' at screen 0.03, graph 0.5 center rotate
plot $dopri5 using 1:2 with linespoints lw 1.5 pt 9 ps 1.3*mark lc rgb '#009E73' title 'dopri5', \
     $exact using 1:2 with linespoints lw 1.5 pt 7 ps 1.3*mark lc rgb '#D55E00' title 'exact', \
     $fehlberg78 using 1:2 with linespoints lw 1.5 pt 13 ps 1.3*mark lc rgb '#CC79A7' title 'fehlberg78', \
     $rk4 using 1:2 with linespoints lw 1.5 pt 5 ps 1.3*mark lc rgb '#0072B2' title 'rk4', \
     $front using 1:2 with points pt 6 ps 1.9*mark lw 1.5 lc rgb '#000000' title 'beaten by none', \
     $allowed using 1:2 with lines dt (8,4) lc rgb '#999999' title 'solver.tolerance', \
     NaN notitle
$contact0 << EOD
0.125 1.583e-05 0.000195213079
0.0625 1.7532e-05 1.20981441e-05
0.03125 2.1249e-05 7.67724009e-07
0.015625 2.8673e-05 4.82241789e-08
0.0078125 4.298e-05 3.0196381e-09
0.00390625 7.1885e-05 1.88873139e-10
0.001953125 0.000129122 1.18089982e-11
0.0009765625 0.000243685 7.38742401e-13
0.00048828125 0.000922534 4.75175455e-14
0.000244140625 0.000939535 8.32667268e-15
EOD
$contact1 << EOD
0.125 1.412e-06 0.0053784266
0.0625 2.073e-06 0.0014506748
0.03125 3.376e-06 0.000374990713
0.015625 5.991e-06 9.52900587e-05
0.0078125 1.124e-05 2.40182649e-05
0.00390625 2.1731e-05 6.02932544e-06
0.001953125 4.2719e-05 1.51044803e-06
0.0009765625 8.4798e-05 3.78003068e-07
0.00048828125 0.000168836 9.4549746e-08
0.000244140625 0.00033699 2.36435624e-08
EOD
$contact2 << EOD
0 0.000152434 7.43849426e-15
EOD
$contact3 << EOD
0.125 1.6811e-05 0.000549648495
0.0625 1.9076e-05 4.51782171e-05
0.03125 2.3304e-05 6.34360143e-06
0.015625 3.236e-05 1.07340326e-06
0.0078125 5.0274e-05 1.88883509e-07
0.00390625 8.5801e-05 3.34306228e-08
0.001953125 0.000156523 5.91729898e-09
0.0009765625 0.00029987 1.04683917e-09
0.00048828125 0.000583791 1.85130689e-10
0.000244140625 0.001159005 3.27422534e-11
EOD
$contact4 << EOD
0.125 1.422e-06 0.00205887575
0.0625 2.084e-06 0.000371026183
0.03125 3.396e-06 6.81842708e-05
0.015625 6.011e-06 1.23866056e-05
0.0078125 1.1251e-05 2.2235246e-06
0.00390625 2.175e-05 3.96231947e-07
0.001953125 4.2719e-05 7.03307583e-08
0.0009765625 8.4798e-05 1.24583778e-08
0.00048828125 0.000168866 2.20461316e-09
0.000244140625 0.00033701 3.89926647e-10
EOD
$contact5 << EOD
0 9.4878e-05 3.20599103e-12
EOD
unset label
set logscale xy
set format xy '10^{%L}'
set xtics 10
set ytics 100
set yrange [3.71925e-15:0.0107569]
set lmargin at screen 0.175
set rmargin at screen 0.5333
set bmargin at screen 0.1864
set tmargin at screen 0.4633
set xrange [0.00012207:0.25]
set key at screen 0.5, screen 0.008475 center bottom vertical maxcols 1 Left reverse samplen 2 font ',9'
set xlabel 'step / duration of the contact'
set label 'error of speed or duration, relative' at screen 0.03, graph 0.5 center rotate
plot $contact0 using 1:3 with linespoints lw 1.5 dt solid pt 7 ps 0.6*mark lc rgb '#0072B2' title 'linear, located: order 4.00', \
     $contact1 using 1:3 with linespoints lw 1.5 dt (8,4) pt 6 ps 0.6*mark lc rgb '#0072B2' title 'linear, not located: order 1.99', \
     keyentry with points pt 12 ps 1.1*mark lw 2 lc rgb '#0072B2' title 'linear, exact flow', \
     $contact3 using 1:3 with linespoints lw 1.5 dt solid pt 7 ps 0.6*mark lc rgb '#D55E00' title 'Hertz, located: order 2.51', \
     $contact4 using 1:3 with linespoints lw 1.5 dt (8,4) pt 6 ps 0.6*mark lc rgb '#D55E00' title 'Hertz, not located: order 2.49', \
     keyentry with points pt 12 ps 1.1*mark lw 2 lc rgb '#D55E00' title 'Hertz, exact flow', \
     NaN notitle
unset label
unset key
set format y ''
set lmargin at screen 0.6083
set rmargin at screen 0.9667
set bmargin at screen 0.1864
set tmargin at screen 0.4633
set xrange [7.06e-07:0.00231801]
set xlabel 'computing time of the contact (s)'
plot $contact0 using 2:3 with linespoints lw 1.5 dt solid pt 7 ps 0.6*mark lc rgb '#0072B2' notitle, \
     $contact1 using 2:3 with linespoints lw 1.5 dt (8,4) pt 6 ps 0.6*mark lc rgb '#0072B2' notitle, \
     $contact2 using 2:3 with points pt 12 ps 1.1*mark lw 2 lc rgb '#0072B2' notitle, \
     $contact3 using 2:3 with linespoints lw 1.5 dt solid pt 7 ps 0.6*mark lc rgb '#D55E00' notitle, \
     $contact4 using 2:3 with linespoints lw 1.5 dt (8,4) pt 6 ps 0.6*mark lc rgb '#D55E00' notitle, \
     $contact5 using 2:3 with points pt 12 ps 1.1*mark lw 2 lc rgb '#D55E00' notitle, \
     NaN notitle
unset multiplot
