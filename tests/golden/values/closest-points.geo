// Closest points of Bezier curves and splines, near and far.
// Expected values: computed with 40 digits from the definitions, with mpmath, by nothing of this program.
geo 1
curve c0 = bezier([(3, 3, -3), (-4, -2, -2), (-5, -7, -1)])
check closest(c0, (11, 0, 4)).distance ~= 11.045361017187261 within 1.1e-11
check closest(c0, (11, 0, 4)).t ~= 0 within 1e-9
check closest(c0, (11, 0, 4)).point ~= (3, 3, -3) within 3e-9
check closest(c0, (9, 10, 5)).distance ~= 12.206555615733703 within 1.2e-11
check closest(c0, (9, 10, 5)).t ~= 0 within 1e-9
check closest(c0, (9, 10, 5)).point ~= (3, 3, -3) within 3e-9
check closest(c0, (-10, 7, 3)).distance ~= 12.678436810856178 within 1.3e-11
check closest(c0, (-10, 7, 3)).t ~= 0.42567819974828616 within 1e-9
check closest(c0, (-10, 7, 3)).point
    ~= (-1.8722832180303554, -1.2567819974828616, -2.1486436005034277) within 2.1e-9
check closest(c0, (-6, 1, 11)).distance ~= 13.687674295225905 within 1.4e-11
check closest(c0, (-6, 1, 11)).t ~= 0.62420760253356519 within 1e-9
check closest(c0, (-6, 1, 11)).point
    ~= (-3.4010956491057048, -3.2420760253356519, -1.7515847949328696) within 3.4e-9
check closest(c0, (7, 6, -6)).distance ~= 5.8309518948453005 within 5.8e-12
check closest(c0, (7, 6, -6)).t ~= 0 within 1e-9
check closest(c0, (7, 6, -6)).point ~= (3, 3, -3) within 3e-9
check closest(c0, (300, -200, 100)).distance ~= 374.20181720563571 within 3.7e-10
check closest(c0, (300, -200, 100)).t ~= 0 within 1e-9
check closest(c0, (300, -200, 100)).point ~= (3, 3, -3) within 3e-9
check closest(c0, (1000000, 0, 0)).distance ~= 999997.00000900003 within 1e-6
check closest(c0, (1000000, 0, 0)).t ~= 0 within 1e-9
check closest(c0, (1000000, 0, 0)).point ~= (3, 3, -3) within 3e-9
curve c1 = bezier([(2, 3, -3), (-5, 5, -4), (9, 1, -7), (7, -7, 6)], weights = [3, 5, 1, 3])
check closest(c1, (5, -12, 1)).distance ~= 7.2395892864384966 within 7.2e-12
check closest(c1, (5, -12, 1)).t ~= 0.94063918512351322 within 1e-9
check closest(c1, (5, -12, 1)).point
    ~= (6.894770881902905, -6.3110519881068523, 5.056768031251596) within 6.9e-9
check closest(c1, (-6, -1, 5)).distance ~= 9.8972617645459084 within 9.9e-12
check closest(c1, (-6, -1, 5)).t ~= 0.62121983404652671 within 1e-9
check closest(c1, (-6, -1, 5)).point
    ~= (0.98680265418616424, 0.96994452633645655, -1.7275328070962681) within 1.7e-9
check closest(c1, (-10, 2, 4)).distance ~= 11.26170110606139 within 1.1e-11
check closest(c1, (-10, 2, 4)).t ~= 0.35065095351443531 within 1e-9
check closest(c1, (-10, 2, 4)).point
    ~= (-1.8735158760972579, 3.7814138054421843, -3.5903051611908874) within 3.8e-9
check closest(c1, (-6, 7, 2)).distance ~= 7.6141585418552739 within 7.6e-12
check closest(c1, (-6, 7, 2)).t ~= 0.29648794297187801 within 1e-9
check closest(c1, (-6, 7, 2)).point
    ~= (-1.9089781787765538, 3.9258814104009101, -3.6381509075105936) within 3.9e-9
check closest(c1, (-11, -1, -8)).distance ~= 11.198523848655919 within 1.1e-11
check closest(c1, (-11, -1, -8)).t ~= 0.33036767716995876 within 1e-9
check closest(c1, (-11, -1, -8)).point
    ~= (-1.906583611548957, 3.8474421601724676, -3.6160498087971099) within 3.8e-9
check closest(c1, (300, -200, 100)).distance ~= 363.22720162454794 within 3.6e-10
check closest(c1, (300, -200, 100)).t ~= 1 within 1e-9
check closest(c1, (300, -200, 100)).point ~= (7, -7, 6) within 7e-9
check closest(c1, (1000000, 0, 0)).distance ~= 999992.98368970733 within 1e-6
check closest(c1, (1000000, 0, 0)).t ~= 0.98379185375318598 within 1e-9
check closest(c1, (1000000, 0, 0)).point
    ~= (7.0163504670508857, -6.8544638643769786, 5.7762026890775793) within 7e-9
curve c2 = bezier([(-3, -4, 5), (-4, 7, -4), (-8, -6, -9), (-4, 6, 4), (-7, 4, -7)])
check closest(c2, (-8, -3, 7)).distance ~= 5.4772255750516611 within 5.5e-12
check closest(c2, (-8, -3, 7)).t ~= 0 within 1e-9
check closest(c2, (-8, -3, 7)).point ~= (-3, -4, 5) within 5e-9
check closest(c2, (-12, 0, -2)).distance ~= 6.5260655747211681 within 6.5e-12
check closest(c2, (-12, 0, -2)).t ~= 0.59264643234467234 within 1e-9
check closest(c2, (-12, 0, -2)).point
    ~= (-5.741319880790567, 1.4418608387619844, -3.1573644078758925) within 5.7e-9
check closest(c2, (-8, 4, 0)).distance ~= 3.5182938575418843 within 3.5e-12
check closest(c2, (-8, 4, 0)).t ~= 0.79152813623420982 within 1e-9
check closest(c2, (-8, 4, 0)).point
    ~= (-5.8291709112227587, 3.2642815854858973, -2.6691967237130312) within 5.8e-9
check closest(c2, (-6, -11, 8)).distance ~= 8.18535277187245 within 8.2e-12
check closest(c2, (-6, -11, 8)).t ~= 0 within 1e-9
check closest(c2, (-6, -11, 8)).point ~= (-3, -4, 5) within 5e-9
check closest(c2, (-6, 2, -4)).distance ~= 1.0428154984859514 within 1e-12
check closest(c2, (-6, 2, -4)).t ~= 0.58842084332834594 within 1e-9
check closest(c2, (-6, 2, -4)).point
    ~= (-5.7385970927953193, 1.4144378701185705, -3.177655986805906) within 5.7e-9
check closest(c2, (300, -200, 100)).distance ~= 373.16216314090581 within 3.7e-10
check closest(c2, (300, -200, 100)).t ~= 0 within 1e-9
check closest(c2, (300, -200, 100)).point ~= (-3, -4, 5) within 5e-9
check closest(c2, (1000000, 0, 0)).distance ~= 1000003.0000204999 within 1e-6
check closest(c2, (1000000, 0, 0)).t ~= 0 within 1e-9
check closest(c2, (1000000, 0, 0)).point ~= (-3, -4, 5) within 5e-9
curve c3 = bezier(
    [(8, 3, -5), (2, 6, -8), (-5, -5, 4), (-6, -6, -6), (-5, 0, -4), (-4, 4, -5)],
    weights = [2, 3, 5, 2, 3, 1],
)
check closest(c3, (-1, -7, 9)).distance ~= 11.347381863600134 within 1.1e-11
check closest(c3, (-1, -7, 9)).t ~= 0.46369356609450044 within 1e-9
check closest(c3, (-1, -7, 9)).point
    ~= (-3.5926280082646844, -2.4103355572638543, -1.0486981978864428) within 3.6e-9
check closest(c3, (-10, 4, -3)).distance ~= 6.0635132352146411 within 6.1e-12
check closest(c3, (-10, 4, -3)).t ~= 0.9634187004721322 within 1e-9
check closest(c3, (-10, 4, -3)).point
    ~= (-4.3933231601561725, 2.3817091129413938, -4.6469675686075379) within 4.6e-9
check closest(c3, (-12, 6, -11)).distance ~= 10.19803902718557 within 1e-11
check closest(c3, (-12, 6, -11)).t ~= 1 within 1e-9
check closest(c3, (-12, 6, -11)).point ~= (-4, 4, -5) within 5e-9
check closest(c3, (-2, -6, 0)).distance ~= 4.0359076112310642 within 4e-12
check closest(c3, (-2, -6, 0)).t ~= 0.49009732844394984 within 1e-9
check closest(c3, (-2, -6, 0)).point
    ~= (-3.8298382330694068, -2.5718165756974403, -1.0898626961812402) within 3.8e-9
check closest(c3, (0, -2, 0)).distance ~= 2.6987977680126585 within 2.7e-12
check closest(c3, (0, -2, 0)).t ~= 0.32499424383340788 within 1e-9
check closest(c3, (0, -2, 0)).point
    ~= (-1.8861841382552305, -0.91765396901103631, -1.5982321040533875) within 1.9e-9
check closest(c3, (300, -200, 100)).distance ~= 370.80722754552668 within 3.7e-10
check closest(c3, (300, -200, 100)).t ~= 0 within 1e-9
check closest(c3, (300, -200, 100)).point ~= (8, 3, -5) within 8e-9
check closest(c3, (1000000, 0, 0)).distance ~= 999992.00001700014 within 1e-6
check closest(c3, (1000000, 0, 0)).t ~= 0 within 1e-9
check closest(c3, (1000000, 0, 0)).point ~= (8, 3, -5) within 8e-9
curve c4 = nurbs(
    [
        (3, 4, 2),
        (8, -7, -4),
        (-8, 2, 3),
        (5, -2, 0),
        (-2, 0, -6),
        (1, -3, -2),
        (3, 0, 5),
        (-7, 5, 4),
        (-1, -7, 7),
    ],
    weights = [1, 1, 1, 1, 1, 1, 1, 1, 1],
    degree = 3,
    knots = [0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6],
)
check closest(c4, (-3, 9, -2)).distance ~= 8.7749643873921221 within 8.8e-12
check closest(c4, (-3, 9, -2)).t ~= 0 within 1e-9
check closest(c4, (-3, 9, -2)).point ~= (3, 4, 2) within 4e-9
check closest(c4, (3, 5, -8)).distance ~= 7.5986485416629355 within 7.6e-12
check closest(c4, (3, 5, -8)).t ~= 2.8635155135845073 within 2.9e-9
check closest(c4, (3, 5, -8)).point
    ~= (0.020063539335174444, -0.80699999675407903, -4.1092173810639619) within 4.1e-9
check closest(c4, (-4, 1, -3)).distance ~= 4.2160578280774065 within 4.2e-12
check closest(c4, (-4, 1, -3)).t ~= 3.1718931384507073 within 3.2e-9
check closest(c4, (-4, 1, -3)).point
    ~= (-0.53869479948000903, -0.98383658569734083, -4.3634156812193267) within 4.4e-9
check closest(c4, (1, 9, 7)).distance ~= 7.3484692283495343 within 7.3e-12
check closest(c4, (1, 9, 7)).t ~= 0 within 1e-9
check closest(c4, (1, 9, 7)).point ~= (3, 4, 2) within 4e-9
check closest(c4, (-7, -3, 0)).distance ~= 5.4963987846772733 within 5.5e-12
check closest(c4, (-7, -3, 0)).t ~= 1.097329022200746 within 1.1e-9
check closest(c4, (-7, -3, 0)).point
    ~= (-2.2021525145829801, -0.53363088889879229, 1.0526549836889694) within 2.2e-9
check closest(c4, (300, -200, 100)).distance ~= 369.45771070583978 within 3.7e-10
check closest(c4, (300, -200, 100)).t ~= 6 within 6e-9
check closest(c4, (300, -200, 100)).point ~= (-1, -7, 7) within 7e-9
check closest(c4, (1000000, 0, 0)).distance ~= 999995.37979986818 within 1e-6
check closest(c4, (1000000, 0, 0)).t ~= 0.23197768615494364 within 1e-9
check closest(c4, (1000000, 0, 0)).point
    ~= (4.6202013988816491, -1.3828347241531153, -0.78859130698843031) within 4.6e-9
curve c5 = nurbs(
    [
        (5, -3, 3),
        (1, -3, 2),
        (-9, 2, 0),
        (-3, -4, -1),
        (4, -2, 4),
        (2, 3, -9),
        (-6, 7, 8),
        (-3, -9, 7),
        (0, -4, 7),
        (5, -3, -1),
        (4, 5, 8),
        (7, 0, -3),
        (-9, -6, 0),
    ],
    weights = [1, 1, 1, 5, 3, 3, 3, 2, 1, 5, 5, 2, 3],
    degree = 7,
    knots = [0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6, 6, 6, 6, 6],
)
check closest(c5, (2, -2, -8)).distance ~= 7.5987641127985861 within 7.6e-12
check closest(c5, (2, -2, -8)).t ~= 1.768187443220223 within 1.8e-9
check closest(c5, (2, -2, -8)).point
    ~= (0.80235233146379863, -0.08747152723266147, -0.74403066814228352) within 1e-9
check closest(c5, (-8, 2, 10)).distance ~= 7.283335795581237 within 7.3e-12
check closest(c5, (-8, 2, 10)).t ~= 3.5083912115178414 within 3.5e-9
check closest(c5, (-8, 2, 10)).point
    ~= (-3.133442805953141, -0.1395398051471751, 5.0214489245909588) within 5e-9
check closest(c5, (10, 0, 1)).distance ~= 6.0685747330265374 within 6.1e-12
check closest(c5, (10, 0, 1)).t ~= 5.1408886282484218 within 5.1e-9
check closest(c5, (10, 0, 1)).point
    ~= (4.252859135330458, -0.012740747203218749, 2.9487967686072969) within 4.3e-9
check closest(c5, (5, 10, -7)).distance ~= 11.353492462175223 within 1.1e-11
check closest(c5, (5, 10, -7)).t ~= 2.2314444986722985 within 2.2e-9
check closest(c5, (5, 10, -7)).point
    ~= (0.084522570389668007, 1.9213663237170118, -0.71704284177526581) within 1.9e-9
check closest(c5, (-1, -4, -6)).distance ~= 6.0093563670977688 within 6e-12
check closest(c5, (-1, -4, -6)).t ~= 0.96207820032665661 within 1e-9
check closest(c5, (-1, -4, -6)).point
    ~= (-1.6300360138471374, -2.732480904842408, -0.15972484283103463) within 2.7e-9
check closest(c5, (300, -200, 100)).distance ~= 367.75399386002594 within 3.7e-10
check closest(c5, (300, -200, 100)).t ~= 0 within 1e-9
check closest(c5, (300, -200, 100)).point ~= (5, -3, 3) within 5e-9
check closest(c5, (1000000, 0, 0)).distance ~= 999995.00000900005 within 1e-6
check closest(c5, (1000000, 0, 0)).t ~= 0 within 1e-9
check closest(c5, (1000000, 0, 0)).point ~= (5, -3, 3) within 5e-9
