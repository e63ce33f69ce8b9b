// Bezier curves of degree 7 to 30, with and without weights.
// Expected values: computed with 40 digits from the definitions, with mpmath, by nothing of this program.
geo 1
curve polynomial_7 = bezier([
    (1, -5, 3),
    (-8, -7, 8),
    (-6, 2, 9),
    (-8, 7, -3),
    (-8, -7, 4),
    (4, -7, -2),
    (-7, 8, 4),
    (-8, 9, -6),
])
check polynomial_7(0) ~= (1, -5, 3) within 5e-12
check derivative(polynomial_7, 0) ~= (-63, -14, 35) within 6.3e-11
check derivative(polynomial_7, 0, order = 2) ~= (462, 462, -168) within 4.6e-10
check derivative(polynomial_7, 0, order = 3) ~= (-3150, -3150, -1890) within 3.1e-9
check tangent(polynomial_7, 0)
    ~= (-0.85811633032103308, -0.19069251784911846, 0.47673129462279616) within 1e-12
check normal(polynomial_7, 0)
    ~= (-0.06101993693304418, 0.95977121142144066, 0.27407259808909674) within 1e-12
check binormal(polynomial_7, 0)
    ~= (-0.50981656596569216, 0.20609605858187555, -0.83523139530549567) within 1e-12
check curvature(polynomial_7, 0) ~= 0.068493300989734865 within 1e-12
check center_of_curvature(polynomial_7, 0)
    ~= (0.10911087578930855, 9.0126289367376554, 7.0014511511158175) within 9e-11
check torsion(polynomial_7, 0) ~= 0.09354041651959054 within 1e-11
check polynomial_7(0.125)
    ~= (-4.1232290267944336, -4.1385717391967773, 5.7361330986022949) within 5.7e-12
check derivative(polynomial_7, 0.125)
    ~= (-24.588813781738281, 20.212638854980469, 8.0311317443847656) within 2.5e-11
check derivative(polynomial_7, 0.125, order = 2)
    ~= (190.7252197265625, 101.3316650390625, -210.31915283203125) within 2.1e-10
check derivative(polynomial_7, 0.125, order = 3)
    ~= (-1322.2412109375, -2404.2333984375, 695.16357421875) within 2.4e-9
check tangent(polynomial_7, 0.125)
    ~= (-0.74902579623085299, 0.61571851520232752, 0.24464477639585495) within 1e-12
check normal(polynomial_7, 0.125)
    ~= (0.3390859116381443, 0.67348427252960152, -0.65684068021385674) within 1e-12
check binormal(polynomial_7, 0.125)
    ~= (-0.5691933776048921, -0.40903501646230069, -0.71323856752030741) within 1e-12
check curvature(polynomial_7, 0.125) ~= 0.25152997353433739 within 1e-12
check center_of_curvature(polynomial_7, 0.125)
    ~= (-2.7751355694878264, -1.4610209762947114, 3.1247517551212218) within 3.1e-11
check torsion(polynomial_7, 0.125) ~= 0.1393743212514591 within 1e-11
check polynomial_7(1/3)
    ~= (-6.3914037494284408, -0.42935528120713306, 4.2697759487882945) within 6.4e-12
check derivative(polynomial_7, 1/3)
    ~= (-0.81618655692729767, 7.1152263374485597, -14.844993141289438) within 1.5e-11
check derivative(polynomial_7, 1/3, order = 2)
    ~= (78.123456790123457, -136.88888888888889, -11.061728395061728) within 1.4e-10
check derivative(polynomial_7, 1/3, order = 3)
    ~= (-142.59259259259259, 132.22222222222222, 736.2962962962963) within 7.4e-10
check tangent(polynomial_7, 1/3)
    ~= (-0.049518952746466475, 0.4316887527662548, -0.90066236407102554) within 1e-12
check normal(polynomial_7, 1/3)
    ~= (0.50722700741542192, -0.76595502046347731, -0.3950109739933684) within 1e-12
check binormal(polynomial_7, 1/3)
    ~= (-0.86038865419488694, -0.47640080537495882, -0.18103490373627367) within 1e-12
check curvature(polynomial_7, 1/3) ~= 0.54790194083858725 within 1e-12
check center_of_curvature(polynomial_7, 1/3)
    ~= (-5.465641364577076, -1.8273335750805779, 3.548823996348069) within 5.5e-11
check torsion(polynomial_7, 1/3) ~= -0.030000413004097452 within 1e-11
check polynomial_7(0.7) ~= (-3.8891318, -0.389541, 0.7289529) within 3.9e-12
check derivative(polynomial_7, 0.7) ~= (2.372762, 17.15371, -4.971211) within 1.7e-11
check derivative(polynomial_7, 0.7, order = 2) ~= (-114.25764, 200.3694, -10.28958) within 2e-10
check derivative(polynomial_7, 0.7, order = 3) ~= (-735.966, 194.25, -536.277) within 7.4e-10
check tangent(polynomial_7, 0.7)
    ~= (0.13169970460280047, 0.952113418809853, -0.27592612331881256) within 1e-12
check normal(polynomial_7, 0.7)
    ~= (-0.94130692882406505, 0.20738821851081218, 0.26632948122714118) within 1e-12
check binormal(polynomial_7, 0.7)
    ~= (0.31079970005671116, 0.2246556577189301, 0.92354392526805854) within 1e-12
check curvature(polynomial_7, 0.7) ~= 0.45092000010899394 within 1e-12
check center_of_curvature(polynomial_7, 0.7)
    ~= (-5.9766571450646178, 0.070381421850180572, 1.3195886694552592) within 6e-11
check torsion(polynomial_7, 0.7) ~= -0.25801210859856957 within 1e-11
check polynomial_7(1) ~= (-8, 9, -6) within 9e-12
check derivative(polynomial_7, 1) ~= (-7, 7, -70) within 7e-11
check derivative(polynomial_7, 1, order = 2) ~= (420, -588, -672) within 6.7e-10
check derivative(polynomial_7, 1, order = 3) ~= (6930, -6090, -5880) within 6.9e-9
check tangent(polynomial_7, 1)
    ~= (-0.099014754297667431, 0.099014754297667431, -0.99014754297667431) within 1e-12
check normal(polynomial_7, 1)
    ~= (0.58866185690477716, -0.79642486522411027, -0.13850867221288874) within 1e-12
check binormal(polynomial_7, 1)
    ~= (-0.8022925256144371, -0.59657649340560708, 0.020571603220883003) within 1e-12
check curvature(polynomial_7, 1) ~= 0.16178744065202971 within 1e-12
check center_of_curvature(polynomial_7, 1)
    ~= (-4.3615107913669065, 4.0773381294964029, -6.8561151079136691) within 6.9e-11
check torsion(polynomial_7, 1) ~= -0.035820083429055075 within 1e-11
curve rational_7 = bezier(
    [
        (1, -5, 3),
        (-8, -7, 8),
        (-6, 2, 9),
        (-8, 7, -3),
        (-8, -7, 4),
        (4, -7, -2),
        (-7, 8, 4),
        (-8, 9, -6),
    ],
    weights = [2, 1, 5, 1, 2, 1, 2, 3],
)
check rational_7(0) ~= (1, -5, 3) within 5e-12
check derivative(rational_7, 0) ~= (-31.5, -7, 17.5) within 3.1e-11
check derivative(rational_7, 0, order = 2) ~= (-577.5, 770, 542.5) within 7.7e-10
check derivative(rational_7, 0, order = 3) ~= (11103.75, -105, -8321.25) within 1.1e-8
check tangent(rational_7, 0)
    ~= (-0.85811633032103308, -0.19069251784911846, 0.47673129462279616) within 1e-12
check normal(rational_7, 0)
    ~= (-0.06101993693304418, 0.95977121142144066, 0.27407259808909674) within 1e-12
check binormal(rational_7, 0)
    ~= (-0.50981656596569216, 0.20609605858187555, -0.83523139530549567) within 1e-12
check curvature(rational_7, 0) ~= 0.68493300989734865 within 1e-12
check center_of_curvature(rational_7, 0)
    ~= (0.91091108757893085, -3.5987371063262345, 3.4001451151115818) within 3.6e-11
check torsion(rational_7, 0) ~= 0.037416166607836216 within 1e-11
check rational_7(0.125)
    ~= (-3.7726953308509833, -2.3148550398557822, 6.2732704206361135) within 6.3e-12
check derivative(rational_7, 0.125)
    ~= (-26.88702552106733, 27.88665500636514, 17.773376231080677) within 2.8e-11
check derivative(rational_7, 0.125, order = 2)
    ~= (258.38527871763093, -132.55026702211668, -232.31094909966899) within 2.6e-10
check derivative(rational_7, 0.125, order = 3)
    ~= (-1504.2101156143972, -1966.16004024904, 771.4471814771334) within 2e-9
check tangent(rational_7, 0.125)
    ~= (-0.63085358626559505, 0.65430801580979408, 0.4170189122124891) within 1e-12
check normal(rational_7, 0.125)
    ~= (0.29476675504216139, 0.69927240895745252, -0.65125314447820956) within 1e-12
check binormal(rational_7, 0.125)
    ~= (-0.71772997207707011, -0.28792207021673683, -0.63400675758571897) within 1e-12
check curvature(rational_7, 0.125) ~= 0.07419216355311225 within 1e-12
check center_of_curvature(rational_7, 0.125)
    ~= (0.20032204626251064, 7.1102968288703738, -2.5046531940593157) within 7.1e-11
check torsion(rational_7, 0.125) ~= 0.20136693981086224 within 1e-11
check rational_7(1/3)
    ~= (-6.1015285903000566, 0.37120211360634082, 6.6197395735044348) within 6.6e-12
check derivative(rational_7, 1/3)
    ~= (-3.0218702314910493, 0.53929419648232525, -8.2723008229413441) within 8.3e-12
check derivative(rational_7, 1/3, order = 2)
    ~= (41.500236722209051, -90.12813421473478, -59.968828177529916) within 9e-11
check derivative(rational_7, 1/3, order = 3)
    ~= (-164.31775577109741, 370.13094293312543, 267.19300086328648) within 3.7e-10
check tangent(rational_7, 1/3)
    ~= (-0.34248120503504878, 0.061120469156791517, -0.9375344860045387) within 1e-12
check normal(rational_7, 1/3)
    ~= (0.49073173379861384, -0.83930643159346926, -0.23398093796043196) within 1e-12
check binormal(rational_7, 1/3)
    ~= (-0.80117974864617445, -0.54021199740091927, 0.25745292428590109) within 1e-12
check curvature(rational_7, 1/3) ~= 1.4134518056423741 within 1.4e-12
check center_of_curvature(rational_7, 1/3)
    ~= (-5.7543418437554229, -0.22259700161147737, 6.4542008992982108) within 6.5e-11
check torsion(rational_7, 1/3) ~= 0.00050311570836730287 within 1e-11
check rational_7(0.7)
    ~= (-5.3776940468519386, 0.96613883404110694, 1.4591702184738831) within 5.4e-12
check derivative(rational_7, 0.7)
    ~= (-0.38470008786485938, 26.360140915511922, -15.448230421131552) within 2.6e-11
check derivative(rational_7, 0.7, order = 2)
    ~= (-84.082960242387645, 198.35676311159723, -5.3835119870253036) within 2e-10
check derivative(rational_7, 0.7, order = 3)
    ~= (-490.13772276702315, -1225.1847863357935, -357.78466916638548) within 1.2e-9
check tangent(rational_7, 0.7)
    ~= (-0.012590111396017193, 0.86269049841649697, -0.50557550676128676) within 1e-12
check normal(rational_7, 0.7)
    ~= (-0.65029916383161666, 0.37701857384602253, 0.65952103264036352) within 1e-12
check binormal(rational_7, 0.7)
    ~= (0.75957388489529843, 0.3370787725695691, 0.55626020392263964) within 1e-12
check curvature(rational_7, 0.7) ~= 0.13486032177956835 within 1e-12
check center_of_curvature(rational_7, 0.7)
    ~= (-10.199714009806962, 3.7617615114233117, 6.3495710712789258) within 1e-10
check torsion(rational_7, 0.7) ~= -0.25583831360525363 within 1e-11
check rational_7(1) ~= (-8, 9, -6) within 9e-12
check derivative(rational_7, 1)
    ~= (-4.6666666666666667, 4.6666666666666667, -46.666666666666667) within 4.7e-11
check derivative(rational_7, 1, order = 2)
    ~= (133.77777777777778, -189.77777777777778, -286.22222222222222) within 2.9e-10
check derivative(rational_7, 1, order = 3)
    ~= (1163.5555555555556, 628.44444444444444, -2756.4444444444444) within 2.8e-9
check tangent(rational_7, 1)
    ~= (-0.099014754297667431, 0.099014754297667431, -0.99014754297667431) within 1e-12
check normal(rational_7, 1)
    ~= (0.58866185690477716, -0.79642486522411027, -0.13850867221288874) within 1e-12
check binormal(rational_7, 1)
    ~= (-0.8022925256144371, -0.59657649340560708, 0.020571603220883003) within 1e-12
check curvature(rational_7, 1) ~= 0.12134058048902228 within 1e-12
check center_of_curvature(rational_7, 1)
    ~= (-3.1486810551558753, 2.4364508393285372, -7.1414868105515588) within 7.1e-11
check torsion(rational_7, 1) ~= -0.10746025028716523 within 1e-11
curve polynomial_12 = bezier([
    (4, -5, 8),
    (-6, 9, 0),
    (8, -4, -6),
    (9, 9, -3),
    (2, -6, 8),
    (-7, 9, -8),
    (-3, 6, 8),
    (4, 1, 5),
    (9, 5, 2),
    (0, -2, -4),
    (-2, -7, 9),
    (0, 7, 6),
    (1, 5, 0),
])
check polynomial_12(0) ~= (4, -5, 8) within 8e-12
check derivative(polynomial_12, 0) ~= (-120, 168, -96) within 1.7e-10
check derivative(polynomial_12, 0, order = 2) ~= (3168, -3564, 264) within 3.6e-9
check derivative(polynomial_12, 0, order = 3) ~= (-48840, 69960, 9240) within 7e-8
check tangent(polynomial_12, 0)
    ~= (-0.52704627669472989, 0.73786478737262184, -0.42163702135578391) within 1e-12
check normal(polynomial_12, 0)
    ~= (0.46053231457248838, -0.16899533630399139, -0.87140723174759541) within 1e-12
check binormal(polynomial_12, 0)
    ~= (-0.7142354019906384, -0.65344941033186066, -0.25074221559245816) within 1e-12
check curvature(polynomial_12, 0) ~= 0.035324348803466499 within 1e-12
check center_of_curvature(polynomial_12, 0)
    ~= (17.037248531734993, -9.7841033742540584, -16.668741569613344) within 1.7e-10
check torsion(polynomial_12, 0) ~= -0.031536862767738583 within 1e-11
check polynomial_12(0.125)
    ~= (2.0798170411435422, 2.0240493265300756, -0.13408594846259803) within 2.1e-12
check derivative(polynomial_12, 0.125)
    ~= (23.914013550616801, 8.0340168164111674, -29.120328795164824) within 2.9e-11
check derivative(polynomial_12, 0.125, order = 2)
    ~= (-50.061751283705235, -231.47124082222581, 530.3238972723484) within 5.3e-10
check derivative(polynomial_12, 0.125, order = 3)
    ~= (-9151.6703635454178, 6086.7696377635002, -3209.1561055183411) within 9.2e-9
check tangent(polynomial_12, 0.125)
    ~= (0.62068923883454004, 0.20852324817861972, -0.75581937244558443) within 1e-12
check normal(polynomial_12, 0.125)
    ~= (0.75890786691417408, -0.40197214710875505, 0.51232532875562148) within 1e-12
check binormal(polynomial_12, 0.125)
    ~= (-0.196986594292042, -0.89159208605607035, -0.40774971949887016) within 1e-12
check curvature(polynomial_12, 0.125) ~= 0.22012052899049069 within 1e-12
check center_of_curvature(polynomial_12, 0.125)
    ~= (5.5275094049346507, 0.1979036737267406, 2.1933904168961013) within 5.5e-11
check torsion(polynomial_12, 0.125) ~= -0.18393875667845447 within 1e-11
check polynomial_12(1/3)
    ~= (1.8099638529959111, 2.8427558280223016, 0.19423416710415644) within 2.8e-12
check derivative(polynomial_12, 1/3)
    ~= (-18.600077901403919, 6.556046673102, 13.349997459736829) within 1.9e-11
check derivative(polynomial_12, 1/3, order = 2)
    ~= (34.038916831783773, 13.564598892445257, 5.9216582837982015) within 3.4e-11
check derivative(polynomial_12, 1/3, order = 3)
    ~= (3042.3106233805822, -849.88873647309861, -644.40786465477824) within 3e-9
check tangent(polynomial_12, 1/3)
    ~= (-0.78101478662609402, 0.27528752409778836, 0.56056461014543758) within 1e-12
check normal(polynomial_12, 1/3)
    ~= (0.59514409951559243, 0.60010548171308797, 0.53448752242655511) within 1e-12
check binormal(polynomial_12, 1/3)
    ~= (-0.18926014869266969, 0.75105937840760116, -0.63252700039035198) within 1e-12
check curvature(polynomial_12, 1/3) ~= 0.055650802634409964 within 1e-12
check center_of_curvature(polynomial_12, 1/3)
    ~= (12.504222899452204, 13.626166907560464, 9.7985434874529553) within 1.4e-10
check torsion(polynomial_12, 1/3) ~= -1.0729173137604857 within 1.1e-11
check polynomial_12(0.7) ~= (1.981380635182, 0.931193359511, 2.691047649312) within 2.7e-12
check derivative(polynomial_12, 0.7)
    ~= (-5.20609901208, -15.24173014644, 3.25778742432) within 1.5e-11
check derivative(polynomial_12, 0.7, order = 2)
    ~= (-170.2990969944, 72.1549406028, 79.7739559056) within 1.7e-10
check derivative(polynomial_12, 0.7, order = 3)
    ~= (632.91353928, 2142.67304724, 1003.76829168) within 2.1e-9
check tangent(polynomial_12, 0.7)
    ~= (-0.31681726527475763, -0.92753580979660959, 0.19825272247505588) within 1e-12
check normal(polynomial_12, 0.7)
    ~= (-0.84108417720184066, 0.37135024069297783, 0.39328921368119179) within 1e-12
check binormal(polynomial_12, 0.7)
    ~= (-0.43841102550520619, -0.042146414820422262, -0.89778586112349661) within 1e-12
check curvature(polynomial_12, 0.7) ~= 0.74586940933624251 within 1e-12
check center_of_curvature(polynomial_12, 0.7)
    ~= (0.85372455132365966, 1.4290690412921399, 3.2183372911156292) within 3.2e-11
check torsion(polynomial_12, 0.7) ~= -0.38341702350488882 within 1e-11
check polynomial_12(1) ~= (1, 5, 0) within 5e-12
check derivative(polynomial_12, 1) ~= (12, -24, -72) within 7.2e-11
check derivative(polynomial_12, 1, order = 2) ~= (-132, -2112, -396) within 2.1e-9
check derivative(polynomial_12, 1, order = 3) ~= (-6600, -46200, 17160) within 4.6e-8
check tangent(polynomial_12, 1)
    ~= (0.15617376188860607, -0.31234752377721213, -0.93704257133163639) within 1e-12
check normal(polynomial_12, 1)
    ~= (-0.15240998561973751, -0.94494191084237256, 0.28957897267750127) within 1e-12
check binormal(polynomial_12, 1)
    ~= (-0.97590007294853318, 0.097590007294853318, -0.19518001458970664) within 1e-12
check curvature(polynomial_12, 1) ~= 0.3220125610807259 within 1e-12
check center_of_curvature(polynomial_12, 1)
    ~= (0.5266955266955267, 2.0655122655122655, 0.89927849927849928) within 2.1e-11
check torsion(polynomial_12, 1) ~= -0.0097001763668430335 within 1e-11
curve rational_12 = bezier(
    [
        (4, -5, 8),
        (-6, 9, 0),
        (8, -4, -6),
        (9, 9, -3),
        (2, -6, 8),
        (-7, 9, -8),
        (-3, 6, 8),
        (4, 1, 5),
        (9, 5, 2),
        (0, -2, -4),
        (-2, -7, 9),
        (0, 7, 6),
        (1, 5, 0),
    ],
    weights = [1, 1, 5, 2, 3, 2, 5, 5, 1, 1, 3, 3, 3],
)
check rational_12(0) ~= (4, -5, 8) within 8e-12
check derivative(rational_12, 0) ~= (-120, 168, -96) within 1.7e-10
check derivative(rational_12, 0, order = 2) ~= (5280, -3036, -7128) within 7.1e-9
check derivative(rational_12, 0, order = 3) ~= (84480, -193512, 368544) within 3.7e-7
check tangent(rational_12, 0)
    ~= (-0.52704627669472989, 0.73786478737262184, -0.42163702135578391) within 1e-12
check normal(rational_12, 0)
    ~= (0.46053231457248838, -0.16899533630399139, -0.87140723174759541) within 1e-12
check binormal(rational_12, 0)
    ~= (-0.7142354019906384, -0.65344941033186066, -0.25074221559245816) within 1e-12
check curvature(rational_12, 0) ~= 0.1766217440173325 within 1e-12
check center_of_curvature(rational_12, 0)
    ~= (6.6074497063469987, -5.9568206748508117, 3.0662516860773312) within 6.6e-11
check torsion(rational_12, 0) ~= -0.012614745107095433 within 1e-11
check rational_12(0.125)
    ~= (5.1891467472090919, -0.66038112613757421, -2.761345941353828) within 5.2e-12
check derivative(rational_12, 0.125)
    ~= (14.120742108503118, 1.3737334841740551, -10.228348151519405) within 1.4e-11
check derivative(rational_12, 0.125, order = 2)
    ~= (-390.06123053891456, 72.065636368705767, 621.13922894520805) within 6.2e-10
check derivative(rational_12, 0.125, order = 3)
    ~= (1402.9597670082613, 1384.6411396609172, -10343.046292234042) within 1e-8
check tangent(rational_12, 0.125)
    ~= (0.80735890905832855, 0.078543744981490391, -0.5848097742757282) within 1e-12
check normal(rational_12, 0.125)
    ~= (0.50714687734322209, 0.41424880425131819, 0.7557777272302829) within 1e-12
check binormal(rational_12, 0.125)
    ~= (0.30161836277846945, -0.90676833221095435, 0.29461424767685613) within 1e-12
check curvature(rational_12, 0.125) ~= 0.98553899755667885 within 1e-12
check center_of_curvature(rational_12, 0.125)
    ~= (5.7037350878029463, -0.24005396985221927, -1.9944785427993454) within 5.7e-11
check torsion(rational_12, 0.125) ~= -0.73576715856696395 within 1e-11
check rational_12(1/3) ~= (2.2580910612534062, 1.463060051712631, 1.0972432577340364) within 2.3e-12
check derivative(rational_12, 1/3)
    ~= (-25.109955929609187, 15.740688815950352, 26.400987691247501) within 2.6e-11
check derivative(rational_12, 1/3, order = 2)
    ~= (96.070700444619703, -18.60894185828703, -65.902432319530409) within 9.6e-11
check derivative(rational_12, 1/3, order = 3)
    ~= (2609.7056392202411, -1408.2751261093095, -1354.2071663796596) within 2.6e-9
check tangent(rational_12, 1/3)
    ~= (-0.63265291025135332, 0.39659140050617015, 0.66518084472949732) within 1e-12
check normal(rational_12, 1/3)
    ~= (0.67982823427398735, 0.6957945250713546, 0.23174026573869432) within 1e-12
check binormal(rational_12, 1/3)
    ~= (-0.37092299340214224, 0.59881987268734046, -0.70981046275770809) within 1e-12
check curvature(rational_12, 1/3) ~= 0.023545694109820211 within 1e-12
check center_of_curvature(rational_12, 1/3)
    ~= (31.130811105231687, 31.013878210908852, 10.939393786736378) within 3.1e-10
check torsion(rational_12, 1/3) ~= -0.57743508846468775 within 1e-11
check rational_12(0.7)
    ~= (1.1063234854243842, 0.97133230363369356, 4.8547476955456445) within 4.9e-12
check derivative(rational_12, 0.7)
    ~= (-3.7690974964748386, -17.223678873439142, 2.8545483314066457) within 1.7e-11
check derivative(rational_12, 0.7, order = 2)
    ~= (-149.77138058074337, 47.077845437297068, 37.738271729516421) within 1.5e-10
check derivative(rational_12, 0.7, order = 3)
    ~= (40.10217012668735, 3611.9561041125214, 375.14413357799892) within 3.6e-9
check tangent(rational_12, 0.7)
    ~= (-0.21102575230986537, -0.96432628638830253, 0.15982160443006721) within 1e-12
check normal(rational_12, 0.7)
    ~= (-0.93878850503556038, 0.24549203997408423, 0.2416811972877912) within 1e-12
check binormal(rational_12, 0.7)
    ~= (-0.27229446317388272, -0.099037728618482358, -0.95710357518658286) within 1e-12
check curvature(rational_12, 0.7) ~= 0.50556939084178784 within 1e-12
check center_of_curvature(rational_12, 0.7)
    ~= (-0.75056999357451256, 1.4569076656336216, 5.3327853332384347) within 5.3e-11
check torsion(rational_12, 0.7) ~= -0.2526158978293018 within 1e-11
check rational_12(1) ~= (1, 5, 0) within 5e-12
check derivative(rational_12, 1) ~= (12, -24, -72) within 7.2e-11
check derivative(rational_12, 1, order = 2) ~= (-132, -2112, -396) within 2.1e-9
check derivative(rational_12, 1, order = 3) ~= (-7480, -52360, 13640) within 5.2e-8
check tangent(rational_12, 1)
    ~= (0.15617376188860607, -0.31234752377721213, -0.93704257133163639) within 1e-12
check normal(rational_12, 1)
    ~= (-0.15240998561973751, -0.94494191084237256, 0.28957897267750127) within 1e-12
check binormal(rational_12, 1)
    ~= (-0.97590007294853318, 0.097590007294853318, -0.19518001458970664) within 1e-12
check curvature(rational_12, 1) ~= 0.3220125610807259 within 1e-12
check center_of_curvature(rational_12, 1)
    ~= (0.5266955266955267, 2.0655122655122655, 0.89927849927849928) within 2.1e-11
check torsion(rational_12, 1) ~= -0.0032333921222810112 within 1e-11
curve polynomial_20 = bezier([
    (6, 9, 5),
    (-7, -7, -1),
    (6, -7, -8),
    (0, 9, 5),
    (0, 3, 2),
    (-9, 5, 2),
    (-4, -6, 6),
    (-8, -3, 0),
    (-5, -2, 3),
    (3, 6, -7),
    (-4, 5, 3),
    (8, -1, -5),
    (4, 8, -1),
    (4, 2, 3),
    (-2, -5, -7),
    (-4, -5, -2),
    (-2, -9, 6),
    (9, -4, -1),
    (0, -9, -5),
    (4, 8, 2),
    (9, 1, -5),
])
check polynomial_20(0) ~= (6, 9, 5) within 9e-12
check derivative(polynomial_20, 0) ~= (-260, -320, -120) within 3.2e-10
check derivative(polynomial_20, 0, order = 2) ~= (9880, 6080, -380) within 9.9e-9
check derivative(polynomial_20, 0, order = 3) ~= (-307800, 0, 143640) within 3.1e-7
check tangent(polynomial_20, 0)
    ~= (-0.605470362682409, -0.7451942925321957, -0.27944785969957339) within 1e-12
check normal(polynomial_20, 0)
    ~= (0.69622226154383088, -0.32582303902742155, -0.63962012927184279) within 1e-12
check binormal(polynomial_20, 0)
    ~= (0.38559071882505892, -0.58182885251281212, 0.716097049246538) within 1e-12
check curvature(polynomial_20, 0) ~= 0.027878131864911206 within 1e-12
check center_of_curvature(polynomial_20, 0)
    ~= (30.973777472518903, -2.6874057632792289, -17.943435821713014) within 3.1e-10
check torsion(polynomial_20, 0) ~= -0.0071685097606940938 within 1e-11
check polynomial_20(0.125)
    ~= (-0.083498612847465841, 0.011155299006741521, -0.30202939085135349) within 1e-12
check derivative(polynomial_20, 0.125)
    ~= (-16.40290493482809, 30.623566045383218, 21.116536504497545) within 3.1e-11
check derivative(polynomial_20, 0.125, order = 2)
    ~= (-380.41700120419015, -71.014172969672491, 297.339834607278) within 3.8e-10
check derivative(polynomial_20, 0.125, order = 3)
    ~= (1563.2575745172314, -20622.505169290207, -14324.518623807599) within 2.1e-8
check tangent(polynomial_20, 0.125)
    ~= (-0.4034735377660006, 0.75326892281784927, 0.5194179764307592) within 1e-12
check normal(polynomial_20, 0.125)
    ~= (-0.66696260052637189, -0.6307462763573825, 0.39663588385368732) within 1e-12
check binormal(polynomial_20, 0.125)
    ~= (0.62639443948816065, -0.18640028105701316, 0.75689163121293629) within 1e-12
check curvature(polynomial_20, 0.125) ~= 0.25197241163473241 within 1e-12
check center_of_curvature(polynomial_20, 0.125)
    ~= (-2.730465382738223, -2.4920801634205233, 1.2720948606110006) within 2.7e-11
check torsion(polynomial_20, 0.125) ~= -0.35550319831570311 within 1e-11
check polynomial_20(1/3)
    ~= (-3.8477163277294357, 0.24768931074496912, 1.4517783759581526) within 3.8e-12
check derivative(polynomial_20, 1/3)
    ~= (8.9210914363041513, -0.27898804976901123, -13.45207816306277) within 1.3e-11
check derivative(polynomial_20, 1/3, order = 2)
    ~= (335.41156523603479, 245.28871543497536, -125.10166244718152) within 3.4e-10
check derivative(polynomial_20, 1/3, order = 3)
    ~= (-1657.6695242362363, -18.932803732019449, 2362.8734286172459) within 2.4e-9
check tangent(polynomial_20, 1/3)
    ~= (0.55260188162947019, -0.017281441666106437, -0.83326617127632751) within 1e-12
check normal(polynomial_20, 1/3)
    ~= (0.54359655067976241, 0.76533305972628155, 0.34462747681964137) within 1e-12
check binormal(polynomial_20, 1/3)
    ~= (0.63177048879211944, -0.64340240865569419, 0.43231862095845187) within 1e-12
check curvature(polynomial_20, 1/3) ~= 1.2544701528362032 within 1.3e-12
check center_of_curvature(polynomial_20, 1/3)
    ~= (-3.4143887196944758, 0.85777402100767035, 1.7264979267107001) within 3.4e-11
check torsion(polynomial_20, 1/3) ~= -0.0025712100963344804 within 1e-11
check polynomial_20(0.7)
    ~= (0.84109484980647369, -2.1152346524912182, -1.0448975442702304) within 2.1e-12
check derivative(polynomial_20, 0.7)
    ~= (-8.4252272309284971, -36.610743827447685, 5.5538004963632548) within 3.7e-11
check derivative(polynomial_20, 0.7, order = 2)
    ~= (128.99561696007912, 49.919270226973004, 43.836867474053347) within 1.3e-10
check derivative(polynomial_20, 0.7, order = 3)
    ~= (4561.3506493850932, 4901.4309626711135, -790.74874204868072) within 4.9e-9
check tangent(polynomial_20, 0.7)
    ~= (-0.22185669208915279, -0.96404978736529518, 0.14624505344177625) within 1e-12
check normal(polynomial_20, 0.7)
    ~= (0.89346371042127532, -0.14092002639698008, 0.42645532511685432) within 1e-12
check binormal(polynomial_20, 0.7)
    ~= (-0.39051530870825837, 0.22527661583307661, 0.89260755095578823) within 1e-12
check curvature(polynomial_20, 0.7) ~= 0.088000887627416816 within 1e-12
check center_of_curvature(polynomial_20, 0.7)
    ~= (10.99398915019209, -3.7165824365455715, 3.8011368153194732) within 1.1e-10
check torsion(polynomial_20, 0.7) ~= -0.28693609141976302 within 1e-11
check polynomial_20(1) ~= (9, 1, -5) within 9e-12
check derivative(polynomial_20, 1) ~= (100, -140, -140) within 1.4e-10
check derivative(polynomial_20, 1, order = 2) ~= (380, -9120, -5320) within 9.1e-9
check derivative(polynomial_20, 1, order = 3) ~= (-82080, -314640, -171000) within 3.1e-7
check tangent(polynomial_20, 1)
    ~= (0.45083481733371614, -0.6311687442672026, -0.6311687442672026) within 1e-12
check normal(polynomial_20, 1)
    ~= (-0.75517845968801524, -0.6466828530607598, 0.10726966756932035) within 1e-12
check binormal(polynomial_20, 1)
    ~= (-0.47587126568317985, 0.42828413911486187, -0.7681921860314189) within 1e-12
check curvature(polynomial_20, 1) ~= 0.10244116206837194 within 1e-12
check center_of_curvature(polynomial_20, 1)
    ~= (1.628173632157851, -5.3127246899946974, -3.9528655727496947) within 5.3e-11
check torsion(polynomial_20, 1) ~= 0.031902209076624457 within 1e-11
curve rational_20 = bezier(
    [
        (6, 9, 5),
        (-7, -7, -1),
        (6, -7, -8),
        (0, 9, 5),
        (0, 3, 2),
        (-9, 5, 2),
        (-4, -6, 6),
        (-8, -3, 0),
        (-5, -2, 3),
        (3, 6, -7),
        (-4, 5, 3),
        (8, -1, -5),
        (4, 8, -1),
        (4, 2, 3),
        (-2, -5, -7),
        (-4, -5, -2),
        (-2, -9, 6),
        (9, -4, -1),
        (0, -9, -5),
        (4, 8, 2),
        (9, 1, -5),
    ],
    weights = [1, 5, 5, 5, 5, 5, 1, 5, 5, 1, 2, 1, 2, 5, 2, 1, 3, 1, 1, 1, 2],
)
check rational_20(0) ~= (6, 9, 5) within 9e-12
check derivative(rational_20, 0) ~= (-1300, -1600, -600) within 1.6e-9
check derivative(rational_20, 0, order = 2) ~= (257400, 286400, 94100) within 2.9e-7
check derivative(rational_20, 0, order = 3) ~= (-69243000, -76032000, -24601800) within 7.6e-5
check tangent(rational_20, 0)
    ~= (-0.605470362682409, -0.7451942925321957, -0.27944785969957339) within 1e-12
check normal(rational_20, 0)
    ~= (0.69622226154383088, -0.32582303902742155, -0.63962012927184279) within 1e-12
check binormal(rational_20, 0)
    ~= (0.38559071882505892, -0.58182885251281212, 0.716097049246538) within 1e-12
check curvature(rational_20, 0) ~= 0.0055756263729822412 within 1e-12
check center_of_curvature(rational_20, 0)
    ~= (130.86888736259452, -49.437028816396145, -109.71717910856507) within 1.3e-9
check torsion(rational_20, 0) ~= -0.0014337019521388188 within 1e-11
check rational_20(0.125)
    ~= (-0.37074607922861987, -0.40946663744508335, -0.74153173662256594) within 1e-12
check derivative(rational_20, 0.125)
    ~= (-6.7643918184781694, 49.341784218834528, 26.484249301546595) within 4.9e-11
check derivative(rational_20, 0.125, order = 2)
    ~= (-547.89952661905522, -363.71084288315923, 34.311525219877988) within 5.5e-10
check derivative(rational_20, 0.125, order = 3)
    ~= (5819.3116261109063, -9590.2845286153475, -8507.0536513135673) within 9.6e-9
check tangent(rational_20, 0.125)
    ~= (-0.11992049157066357, 0.87474102288584674, 0.46951807055966755) within 1e-12
check normal(rational_20, 0.125)
    ~= (-0.93750364053258915, -0.25538849683126692, 0.23635490194706738) within 1e-12
check binormal(rational_20, 0.125)
    ~= (0.32665884296861194, -0.41183110441889709, 0.85069920756018058) within 1e-12
check curvature(rational_20, 0.125) ~= 0.19317937321279613 within 1e-12
check center_of_curvature(rational_20, 0.125)
    ~= (-5.2237675221540246, -1.7314944118594072, 0.48196794668322564) within 5.2e-11
check torsion(rational_20, 0.125) ~= -0.039988327067825497 within 1e-11
check rational_20(1/3)
    ~= (-4.9552054500045458, 0.64396519702391441, 1.5884491969161417) within 5e-12
check derivative(rational_20, 1/3)
    ~= (-5.394513244677014, -13.85137739294963, -2.8695254600730366) within 1.4e-11
check derivative(rational_20, 1/3, order = 2)
    ~= (323.34840711242071, 147.84539792763462, -59.297444811489667) within 3.2e-10
check derivative(rational_20, 1/3, order = 3)
    ~= (289.18021501682739, 3285.3437128407337, 917.01108660000829) within 3.3e-9
check tangent(rational_20, 1/3)
    ~= (-0.35632731947259733, -0.91493411056192261, -0.18954264619799193) within 1e-12
check normal(rational_20, 1/3)
    ~= (0.88312133991632159, -0.26352945678427251, -0.38813518829318609) within 1e-12
check binormal(rational_20, 1/3)
    ~= (0.30516805268880021, -0.30569232691915875, 0.90190058259260252) within 1e-12
check curvature(rational_20, 1/3) ~= 1.176330086359763 within 1.2e-12
check center_of_curvature(rational_20, 1/3)
    ~= (-4.2044626524202357, 0.4199384040003821, 1.2584948815468069) within 4.2e-11
check torsion(rational_20, 1/3) ~= -0.021805490265986773 within 1e-11
check rational_20(0.7)
    ~= (1.2283305228036419, -1.3533267497235992, 0.51447730446481264) within 1.4e-12
check derivative(rational_20, 0.7)
    ~= (-9.1526667745039379, -34.94248827939784, 4.5849642695719144) within 3.5e-11
check derivative(rational_20, 0.7, order = 2)
    ~= (-73.439479047952449, -123.38131011254721, 59.703360536155509) within 1.2e-10
check derivative(rational_20, 0.7, order = 3)
    ~= (3760.2090693247816, 2781.4435118206183, -252.02564389697668) within 3.8e-9
check tangent(rational_20, 0.7)
    ~= (-0.25136999920683764, -0.95966492252780852, 0.12592203924829725) within 1e-12
check normal(rational_20, 0.7)
    ~= (-0.64329254418240926, 0.26285525866176459, 0.71908401149878159) within 1e-12
check binormal(rational_20, 0.7)
    ~= (-0.72317897238379205, 0.099751438403424027, -0.68341921573684949) within 1e-12
check curvature(rational_20, 0.7) ~= 0.043554572000893565 within 1e-12
check center_of_curvature(rational_20, 0.7)
    ~= (-13.54147468086617, 4.6817516952298228, 17.024432022514364) within 1.7e-10
check torsion(rational_20, 0.7) ~= -1.0794815929462324 within 1.1e-11
check rational_20(1) ~= (9, 1, -5) within 9e-12
check derivative(rational_20, 1) ~= (50, -70, -70) within 7e-11
check derivative(rational_20, 1, order = 2) ~= (-810, -3160, -1260) within 3.2e-9
check derivative(rational_20, 1, order = 3) ~= (-45240, -22620, -7800) within 4.5e-8
check tangent(rational_20, 1)
    ~= (0.45083481733371614, -0.6311687442672026, -0.6311687442672026) within 1e-12
check normal(rational_20, 1)
    ~= (-0.75517845968801524, -0.6466828530607598, 0.10726966756932035) within 1e-12
check binormal(rational_20, 1)
    ~= (-0.47587126568317985, 0.42828413911486187, -0.7681921860314189) within 1e-12
check curvature(rational_20, 1) ~= 0.20488232413674388 within 1e-12
check center_of_curvature(rational_20, 1)
    ~= (5.3140868160789255, -2.1563623449973487, -4.4764327863748474) within 5.3e-11
check torsion(rational_20, 1) ~= 0.063804418153248914 within 1e-11
curve polynomial_30 = bezier([
    (8, -6, 2),
    (-9, -7, -3),
    (3, -5, -1),
    (2, 2, 6),
    (-6, -6, 6),
    (5, 6, 6),
    (0, -7, -5),
    (-6, 1, -1),
    (6, -4, 7),
    (-9, -3, 7),
    (2, -5, 8),
    (-9, 7, 0),
    (-7, -1, 7),
    (2, -4, 2),
    (-2, 8, 8),
    (7, 1, -2),
    (-3, -2, 3),
    (-2, -3, 7),
    (6, 2, -9),
    (-9, -1, 6),
    (-1, -3, 2),
    (5, 2, 2),
    (-7, -2, -6),
    (-2, 6, -3),
    (1, -3, 6),
    (-9, 6, 2),
    (-7, -6, 3),
    (-3, 6, -4),
    (4, 1, -7),
    (3, 5, 3),
    (-7, -4, -4),
])
check polynomial_30(0) ~= (8, -6, 2) within 8e-12
check derivative(polynomial_30, 0) ~= (-510, -30, -150) within 5.1e-10
check derivative(polynomial_30, 0, order = 2) ~= (25230, 2610, 6090) within 2.5e-8
check derivative(polynomial_30, 0, order = 3) ~= (-1023120, 48720, -48720) within 1e-6
check tangent(polynomial_30, 0)
    ~= (-0.95784148869231879, -0.056343616981901105, -0.28171808490950553) within 1e-12
check normal(polynomial_30, 0)
    ~= (0.17393131069573452, 0.66673669100031567, -0.72471379456556051) within 1e-12
check binormal(polynomial_30, 0)
    ~= (0.22866478019001178, -0.7431605356175383, -0.6288281455225324) within 1e-12
check curvature(polynomial_30, 0) ~= 0.0060492512291355993 within 1e-12
check center_of_curvature(polynomial_30, 0)
    ~= (36.752535496957404, 104.21805273833671, -117.80223123732252) within 1.2e-9
check torsion(polynomial_30, 0) ~= -0.26230936819172113 within 1e-11
check polynomial_30(0.125)
    ~= (-0.33433812431959702, -2.0511090259557079, 2.7934125051334121) within 2.8e-12
check derivative(polynomial_30, 0.125)
    ~= (1.282142462851359, 19.159018437915102, 9.1524640492392364) within 1.9e-11
check derivative(polynomial_30, 0.125, order = 2)
    ~= (-167.42102108511259, -520.547795125408, -666.19508852872091) within 6.7e-10
check derivative(polynomial_30, 0.125, order = 3)
    ~= (-630.43635986200328, 4117.0006871201343, 15245.315655110469) within 1.5e-8
check tangent(polynomial_30, 0.125)
    ~= (0.060274947635621238, 0.90068683204443061, 0.43026754614924278) within 1e-12
check normal(polynomial_30, 0.125)
    ~= (-0.30636759942373567, 0.42693893176686672, -0.8508008242621208) within 1e-12
check binormal(polynomial_30, 0.125)
    ~= (-0.95000306563234866, -0.080538060092942193, 0.30167498432187757) within 1e-12
check curvature(polynomial_30, 0.125) ~= 0.87484539978869814 within 1e-12
check center_of_curvature(polynomial_30, 0.125)
    ~= (-0.68453439842440776, -1.5630925925721804, 1.8208968761232863) within 1.8e-11
check torsion(polynomial_30, 0.125) ~= 0.57794239561807753 within 1e-11
check polynomial_30(1/3)
    ~= (-2.5478787861167756, -0.9285892641452569, 4.2624727935797702) within 4.3e-12
check derivative(polynomial_30, 1/3)
    ~= (-4.5410965878160782, 15.011489169573596, 4.4470887079761041) within 1.5e-11
check derivative(polynomial_30, 1/3, order = 2)
    ~= (285.62428649435896, 52.286139510353361, -233.52801520700327) within 2.9e-10
check derivative(polynomial_30, 1/3, order = 3)
    ~= (1694.5632992339235, -3505.1443963385811, 15.63384942219557) within 3.5e-9
check tangent(polynomial_30, 1/3)
    ~= (-0.27856711895134431, 0.92085847730195661, 0.27280033911318633) within 1e-12
check normal(polynomial_30, 1/3)
    ~= (0.71923426663098462, 0.38825834979195158, -0.5761575509534005) within 1e-12
check binormal(polynomial_30, 1/3)
    ~= (-0.63647657454374337, 0.035708802807605346, -0.77046898150354518) within 1e-12
check curvature(polynomial_30, 1/3) ~= 1.3557470321678188 within 1.4e-12
check center_of_curvature(polynomial_30, 1/3)
    ~= (-2.0173710663388905, -0.64220962208833687, 3.8374985636659983) within 3.8e-11
check torsion(polynomial_30, 1/3) ~= -0.20700290421186188 within 1e-11
check polynomial_30(0.7)
    ~= (-1.7821301427602876, 0.17063599327521929, 0.33143115887607165) within 1.8e-12
check derivative(polynomial_30, 0.7)
    ~= (-12.621692380166718, 9.0102470266769058, -5.0178041070419892) within 1.3e-11
check derivative(polynomial_30, 0.7, order = 2)
    ~= (-67.828730947581232, 45.643239819028201, 136.46149471966157) within 1.4e-10
check derivative(polynomial_30, 0.7, order = 3)
    ~= (-763.72260492754504, -2197.8114800255496, 1463.3063970814369) within 2.2e-9
check tangent(polynomial_30, 0.7)
    ~= (-0.77436606094074523, 0.55279666846536601, -0.30785231361272285) within 1e-12
check normal(polynomial_30, 0.7)
    ~= (-0.25900604767571347, 0.16697741936343037, 0.9513329641561545) within 1e-12
check binormal(polynomial_30, 0.7)
    ~= (0.57729807805891757, 0.81641557111334013, 0.013876033769005665) within 1e-12
check curvature(polynomial_30, 0.7) ~= 0.58346724809061245 within 1e-12
check center_of_curvature(polynomial_30, 0.7)
    ~= (-2.2260386029580224, 0.45681729978361612, 1.9619133620663568) within 2.2e-11
check torsion(polynomial_30, 0.7) ~= -0.87665228680887122 within 1e-11
check polynomial_30(1) ~= (-7, -4, -4) within 7e-12
check derivative(polynomial_30, 1) ~= (-300, -270, -210) within 3e-10
check derivative(polynomial_30, 1, order = 2) ~= (-7830, -11310, -14790) within 1.5e-8
check derivative(polynomial_30, 1, order = 3) ~= (-24360, -535920, -730800) within 7.3e-7
check tangent(polynomial_30, 1)
    ~= (-0.659380473395787, -0.5934424260562083, -0.4615663313770509) within 1e-12
check normal(polynomial_30, 1)
    ~= (0.58988863898664133, -0.027759465364077239, -0.80700731451281687) within 1e-12
check binormal(polynomial_30, 1)
    ~= (0.46609954398050613, -0.8043976000953896, 0.36836899443620645) within 1e-12
check curvature(polynomial_30, 1) ~= 0.036863621698777167 within 1e-12
check center_of_curvature(polynomial_30, 1)
    ~= (9.0019176576513371, -4.7530314191835923, -25.891699114837291) within 2.6e-10
check torsion(polynomial_30, 1) ~= 0.043359330846614672 within 1e-11
curve rational_30 = bezier(
    [
        (8, -6, 2),
        (-9, -7, -3),
        (3, -5, -1),
        (2, 2, 6),
        (-6, -6, 6),
        (5, 6, 6),
        (0, -7, -5),
        (-6, 1, -1),
        (6, -4, 7),
        (-9, -3, 7),
        (2, -5, 8),
        (-9, 7, 0),
        (-7, -1, 7),
        (2, -4, 2),
        (-2, 8, 8),
        (7, 1, -2),
        (-3, -2, 3),
        (-2, -3, 7),
        (6, 2, -9),
        (-9, -1, 6),
        (-1, -3, 2),
        (5, 2, 2),
        (-7, -2, -6),
        (-2, 6, -3),
        (1, -3, 6),
        (-9, 6, 2),
        (-7, -6, 3),
        (-3, 6, -4),
        (4, 1, -7),
        (3, 5, 3),
        (-7, -4, -4),
    ],
    weights = [
        2, 1, 2, 5, 2, 5, 3, 2, 2, 1, 1, 1, 2, 5, 2, 2, 1, 3, 2, 3, 2, 3, 3, 5, 2, 1, 3, 5, 5, 2, 2,
    ],
)
check rational_30(0) ~= (8, -6, 2) within 8e-12
check derivative(rational_30, 0) ~= (-255, -15, -75) within 2.5e-10
check derivative(rational_30, 0, order = 2) ~= (2790, 1290, -510) within 2.8e-9
check derivative(rational_30, 0, order = 3) ~= (169920, 474780, 452940) within 4.7e-7
check tangent(rational_30, 0)
    ~= (-0.95784148869231879, -0.056343616981901105, -0.28171808490950553) within 1e-12
check normal(rational_30, 0)
    ~= (0.17393131069573452, 0.66673669100031567, -0.72471379456556051) within 1e-12
check binormal(rational_30, 0)
    ~= (0.22866478019001178, -0.7431605356175383, -0.6288281455225324) within 1e-12
check curvature(rational_30, 0) ~= 0.024197004916542397 within 1e-12
check center_of_curvature(rational_30, 0)
    ~= (15.188133874239351, 21.554513184584178, -27.950557809330629) within 2.8e-10
check torsion(rational_30, 0) ~= -1.3115468409586057 within 1.3e-11
check rational_30(0.125)
    ~= (1.188307693494573, -0.032783280059415838, 3.8395113273774123) within 3.8e-12
check derivative(rational_30, 0.125)
    ~= (0.10189019442251742, 11.432725450868895, -3.624226940607199) within 1.1e-11
check derivative(rational_30, 0.125, order = 2)
    ~= (-88.183496907749198, -536.05515202115711, -497.03815059509156) within 5.4e-10
check derivative(rational_30, 0.125, order = 3)
    ~= (-2482.5949211053855, 7223.5996457524507, 13609.249767099832) within 1.4e-8
check tangent(rational_30, 0.125)
    ~= (0.0084951981318176311, 0.95321506100042707, -0.30217359098811607) within 1e-12
check normal(rational_30, 0.125)
    ~= (-0.13268493124643232, -0.29843793970720008, -0.94516110011121974) within 1e-12
check binormal(rational_30, 0.125)
    ~= (-0.9911218596261666, 0.048123212956677274, 0.12394198540404135) within 1e-12
check curvature(rational_30, 0.125) ~= 4.4591538853117665 within 4.5e-12
check center_of_curvature(rational_30, 0.125)
    ~= (1.1585520639157217, -0.099710313165458662, 3.6275515869377442) within 3.6e-11
check torsion(rational_30, 0.125) ~= 0.58424399527557169 within 1e-11
check rational_30(1/3)
    ~= (-1.0444396265166611, -1.2767723368277481, 3.6450154831914636) within 3.6e-12
check derivative(rational_30, 1/3)
    ~= (-5.6476055086615222, 4.1993454669064632, 6.4235382263521821) within 6.4e-12
check derivative(rational_30, 1/3, order = 2)
    ~= (316.05827919790623, 151.48767143895477, -202.8059281234603) within 3.2e-10
check derivative(rational_30, 1/3, order = 3)
    ~= (344.7294373840521, -3724.2106420372404, -1795.7434292934493) within 3.7e-9
check tangent(rational_30, 1/3)
    ~= (-0.59270836304412936, 0.44071548087585933, 0.67414142529139137) within 1e-12
check normal(rational_30, 1/3)
    ~= (0.5230807141992378, 0.84709595389530101, -0.09388829174623085) within 1e-12
check binormal(rational_30, 1/3)
    ~= (-0.61244049736310208, 0.29698200250279499, -0.73261062466979417) within 1e-12
check curvature(rational_30, 1/3) ~= 3.4440302744903669 within 3.4e-12
check center_of_curvature(rational_30, 1/3)
    ~= (-0.8925592211457643, -1.0308116784184225, 3.617754314077576) within 3.6e-11
check torsion(rational_30, 1/3) ~= -0.00052663548645197713 within 1e-11
check rational_30(0.7)
    ~= (-1.8976974184333553, 0.73453813386363358, -0.09343120771422941) within 1.9e-12
check derivative(rational_30, 0.7)
    ~= (-6.7180991724921365, 12.102445459765742, -14.017457449556866) within 1.4e-11
check derivative(rational_30, 0.7, order = 2)
    ~= (-9.0110313058192814, -34.392740555422245, 123.53476297494514) within 1.2e-10
check derivative(rational_30, 0.7, order = 3)
    ~= (-1372.8582197492889, -2651.2452312592195, 2118.9415091130974) within 2.7e-9
check tangent(rational_30, 0.7)
    ~= (-0.34101975469004421, 0.61433641806569856, -0.71154500374140026) within 1e-12
check normal(rational_30, 0.7)
    ~= (-0.62021157681995091, 0.42177146173738764, 0.66139733446878774) within 1e-12
check binormal(rational_30, 0.7)
    ~= (0.70642984569570119, 0.66685800550200684, 0.23718615812950218) within 1e-12
check curvature(rational_30, 0.7) ~= 0.18755498884216269 within 1e-12
check center_of_curvature(rational_30, 0.7)
    ~= (-5.2045226895110088, 2.983326419054652, 3.432987036619373) within 5.2e-11
check torsion(rational_30, 0.7) ~= -1.5588221878748001 within 1.6e-11
check rational_30(1) ~= (-7, -4, -4) within 7e-12
check derivative(rational_30, 1) ~= (-300, -270, -210) within 3e-10
check derivative(rational_30, 1, order = 2) ~= (6525, -4785, -18705) within 1.9e-8
check derivative(rational_30, 1, order = 3) ~= (2209800, 703830, -237510) within 2.2e-6
check tangent(rational_30, 1)
    ~= (-0.659380473395787, -0.5934424260562083, -0.4615663313770509) within 1e-12
check normal(rational_30, 1)
    ~= (0.58988863898664133, -0.027759465364077239, -0.80700731451281687) within 1e-12
check binormal(rational_30, 1)
    ~= (0.46609954398050613, -0.8043976000953896, 0.36836899443620645) within 1e-12
check curvature(rational_30, 1) ~= 0.092159054246942917 within 1e-12
check center_of_curvature(rational_30, 1)
    ~= (-0.59923293693946516, -4.3012125676734369, -12.756679645934917) within 1.3e-10
check torsion(rational_30, 1) ~= 0.043359330846614672 within 1e-11
