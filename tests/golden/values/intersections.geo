// Where plane curves meet.
// Expected values: computed with 40 digits from the definitions, with mpmath, by nothing of this program.
geo 1
curve a0 = bezier((0, 0.5), (0.4, 4), (0.6, -3), (1, 0.5))
curve b0 = bezier((0.5, 0), (4, 0.4), (-3, 0.6), (0.5, 1))
let m0 = intersect(a0, b0)
check len(m0) == 7
check m0[0].t ~= 0.0085618574181749219 within 1e-9
check m0[0].s ~= 0.59693250587192889 within 1e-9
check m0[0].point ~= (0.010230496712501913, 0.58760356295216702, 0) within 1e-9
check m0[1].t ~= 0.049144116110942634 within 1e-9
check m0[1].s ~= 0.95085588388905737 within 1e-9
check m0[1].point ~= (0.057571328893915669, 0.94242867110608433, 0) within 1e-9
check m0[2].t ~= 0.40306749412807111 within 1e-9
check m0[2].s ~= 0.99143814258182508 within 1e-9
check m0[2].point ~= (0.41239643704783298, 0.98976950328749809, 0) within 1e-9
check m0[3].t ~= 0.5 within 1e-9
check m0[3].s ~= 0.5 within 1e-9
check m0[3].point ~= (0.5, 0.5, 0) within 1e-9
check m0[4].t ~= 0.59693250587192889 within 1e-9
check m0[4].s ~= 0.0085618574181749219 within 1e-9
check m0[4].point ~= (0.58760356295216702, 0.010230496712501913, 0) within 1e-9
check m0[5].t ~= 0.95085588388905737 within 1e-9
check m0[5].s ~= 0.049144116110942634 within 1e-9
check m0[5].point ~= (0.94242867110608433, 0.057571328893915669, 0) within 1e-9
check m0[6].t ~= 0.99143814258182508 within 1e-9
check m0[6].s ~= 0.40306749412807111 within 1e-9
check m0[6].point ~= (0.98976950328749809, 0.41239643704783298, 0) within 1e-9
curve a1 = bezier([(-1, 5), (9, 3), (-4, 6)], weights = [1, 1, 3])
curve b1 = bezier([(9, 6), (-4, -7), (8, -2), (5, 7)])
let m1 = intersect(a1, b1)
check len(m1) == 0
curve a2 = bezier([(6, -7), (1, -9), (9, 8), (-1, -9), (9, 1)], weights = [2, 3, 2, 5, 1])
curve b2 = bezier([(4, -1), (-4, -5), (9, -8), (3, -8), (-8, 1)])
let m2 = intersect(a2, b2)
check len(m2) == 4
check m2[0].t ~= 0.65472755429178098 within 1e-9
check m2[0].s ~= 0.29974831494215382 within 1e-9
check m2[0].point ~= (1.8558322071718115, -5.0091305001718423, 0) within 5e-9
check m2[1].t ~= 0.77054746621681215 within 1e-9
check m2[1].s ~= 0.69171602710578973 within 1e-9
check m2[1].point ~= (1.560330707580502, -5.6331630138918775, 0) within 5.6e-9
check m2[2].t ~= 0.84120266467832718 within 1e-9
check m2[2].s ~= 0.68032259208097472 within 1e-9
check m2[2].point ~= (1.7344838375301913, -5.7322116734075878, 0) within 5.7e-9
check m2[3].t ~= 0.88719651203278875 within 1e-9
check m2[3].s ~= 0.35037354781649899 within 1e-9
check m2[3].point ~= (2.1878253752747633, -5.4650259595546762, 0) within 5.5e-9
curve a3 = bezier(
    [(4, -2), (-3, -6), (6, -4), (-1, -1), (2, -7), (8, -3)],
    weights = [2, 1, 1, 5, 2, 3],
)
curve b3 = bezier([(8, -4), (2, 8), (-7, -6), (-5, -5)])
let m3 = intersect(a3, b3)
check len(m3) == 1
check m3[0].t ~= 0.98117617120090763 within 1e-9
check m3[0].s ~= 0.022543688038819887 within 1e-9
check m3[0].point ~= (7.5898000539394794, -3.2275984831828709, 0) within 7.6e-9
curve a4 = bezier([(-2, -4), (1, -8), (1, 4), (-3, 0)], weights = [2, 5, 3, 3])
curve b4 = bezier([(-4, -6), (-5, 6), (7, -9), (-2, 3), (-6, -2), (9, 5), (-7, -4)])
let m4 = intersect(a4, b4)
check len(m4) == 2
check m4[0].t ~= 0.65217648233789214 within 1e-9
check m4[0].s ~= 0.37104056504798474 within 1e-9
check m4[0].point ~= (-0.043676827541967976, -1.3052934419607966, 0) within 1.3e-9
check m4[1].t ~= 0.75599578089877324 within 1e-9
check m4[1].s ~= 0.87906106372639855 within 1e-9
check m4[1].point ~= (-0.61941187924358224, -0.15268758496651855, 0) within 1e-9
curve a5 = bezier(
    [(1, 9), (-8, 9), (3, -9), (0, -4), (-5, -9), (0, 8), (0, 0), (-6, 6)],
    weights = [5, 5, 2, 2, 5, 1, 2, 2],
)
curve b5 = bezier([(4, -7), (-8, 2), (-4, 1), (1, 1), (-8, 3), (-1, -2), (8, -5), (-9, 0)])
let m5 = intersect(a5, b5)
check len(m5) == 6
check m5[0].t ~= 0.30070995786679492 within 1e-9
check m5[0].s ~= 0.43401219565046229 within 1e-9
check m5[0].point ~= (-3.0690928242772984, 0.92878246969869053, 0) within 3.1e-9
check m5[1].t ~= 0.34818023363446344 within 1e-9
check m5[1].s ~= 0.16035586817109742 within 1e-9
check m5[1].point ~= (-2.9098290784118055, -0.93831649195416786, 0) within 2.9e-9
check m5[2].t ~= 0.37077855174237748 within 1e-9
check m5[2].s ~= 0.92698147673829151 within 1e-9
check m5[2].point ~= (-2.8554930835205657, -1.7437982837478055, 0) within 2.9e-9
check m5[3].t ~= 0.75508023866317973 within 1e-9
check m5[3].s ~= 0.92327331731294617 within 1e-9
check m5[3].point ~= (-2.6596539250284223, -1.7938103041503408, 0) within 2.7e-9
check m5[4].t ~= 0.77088809791017617 within 1e-9
check m5[4].s ~= 0.14291929988147361 within 1e-9
check m5[4].point ~= (-2.6260575385963461, -1.306063798646219, 0) within 2.6e-9
check m5[5].t ~= 0.82733190757868149 within 1e-9
check m5[5].s ~= 0.5249200324398229 within 1e-9
check m5[5].point ~= (-2.6290061481099912, 0.57332722996540989, 0) within 2.6e-9
curve a6 = clamped([
    (-1, -4),
    (9, -6),
    (4, -9),
    (9, -9),
    (-3, -5),
    (-4, 0),
    (-8, -1),
    (-4, 9),
    (4, -5),
])
curve b6 = clamped(
    [(-9, -8), (7, 3), (5, -7), (-4, 9), (-2, 1), (4, -5), (6, -7), (2, 7)],
    degree = 2,
)
let m6 = intersect(a6, b6)
check len(m6) == 6
check m6[0].t ~= 0.25208825701565512 within 1e-9
check m6[0].s ~= 4.7628439280344538 within 4.8e-9
check m6[0].point ~= (4.4132018511286529, -5.4132018511286529, 0) within 5.4e-9
check m6[1].t ~= 0.3163202185517891 within 1e-9
check m6[1].s ~= 5.2142574763333168 within 5.2e-9
check m6[1].point ~= (5.1989836218430246, -5.7399209601958065, 0) within 5.7e-9
check m6[2].t ~= 3.2418299793126034 within 3.2e-9
check m6[2].s ~= 0.23370645519059759 within 1e-9
check m6[2].point ~= (-2.4499114562627086, -3.7323573009709297, 0) within 3.7e-9
check m6[3].t ~= 5.6275180528675278 within 5.6e-9
check m6[3].s ~= 3.1457013763885694 within 3.1e-9
check m6[3].point ~= (-2.6661394650598141, 3.8556178799729684, 0) within 3.9e-9
check m6[4].t ~= 5.9018432472933727 within 5.9e-9
check m6[4].s ~= 0.44145547611392439 within 1e-9
check m6[4].point ~= (1.8135652999990622, -1.4061065237492101, 0) within 1.8e-9
check m6[5].t ~= 6 within 6e-9
check m6[5].s ~= 4.6339745962155614 within 4.6e-9
check m6[5].point ~= (4, -5, 0) within 5e-9
curve wide = ellipse((0, 0), 5, 3)
curve tall = ellipse((0, 0), 3, 5)
let four = intersect(wide, tall)
check len(four) == 4
check four[0].point ~= (2.5724787771376326, 2.5724787771376326, 0) within 2.6e-9
check four[1].point ~= (-2.5724787771376326, 2.5724787771376326, 0) within 2.6e-9
check four[2].point ~= (-2.5724787771376326, -2.5724787771376326, 0) within 2.6e-9
check four[3].point ~= (2.5724787771376326, -2.5724787771376326, 0) within 2.6e-9
