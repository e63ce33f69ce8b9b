// The NURBS Book: Skinning parameters by averaging, knots by averaging, skinned surface q=2 and q=3 ((10.8), (9.8))
geo 1
curve section0 = bezier((0, 0, 0), (1, 0, 2), (3, 0, 0))
curve section1 = bezier((0, 1, 1), (1, 2, 3), (3, 1, 0))
curve section2 = bezier((0, 4, 0), (2, 4, 2), (4, 4, 1))
curve section3 = bezier((0, 6, 1), (1, 6, 1), (3, 7, 0))
surface s2 = skin([section0, section1, section2, section3], degree = 2)
check [for u in linspace(0, 1, 5): s2(u, 0)] ~= [for u in linspace(0, 1, 5): section0(u)] within 1e-9
check [for u in linspace(0, 1, 5): s2(u, 0.21732904923268987)] ~= [for u in linspace(0, 1, 5): section1(u)] within 1e-9
check [for u in linspace(0, 1, 5): s2(u, 0.63132389181036945)] ~= [for u in linspace(0, 1, 5): section2(u)] within 1e-9
check [for u in linspace(0, 1, 5): s2(u, 1)] ~= [for u in linspace(0, 1, 5): section3(u)] within 1e-9
check s2.knots_v ~= [0, 0, 0, 0.42432647052152966, 1, 1, 1] within 1e-11
check s2.points ~= [
  [
    (0, 0, 0),
    (0, 0.7130433531778444, 1.6784449221742194),
    (0, 4.8154703753352926, -0.82822801422649497),
    (0, 6, 1),
  ],
  [
    (1, 0, 2),
    (0.71212390192353813, 2.3542677106901693, 3.6040037928504304),
    (2.6829119853166094, 4.2048322714497276, 1.606951806455365),
    (1, 6, 1),
  ],
  [
    (3, 0, 0),
    (2.7121239019235381, 0.7502639178397389, -0.28787609807646187),
    (4.6829119853166094, 4.5978804649943626, 1.6829119853166094),
    (3, 7, 0),
  ],
] within 7e-11
check s2(1/3, 1/2) ~= (1.221094419459753, 3.2127462414796213, 1.3134088027489725) within 3.21e-11
check s2(0.8, 0.1) ~= (2.1696774707053996, 0.60061350148614748, 0.81703074395725407) within 2.17e-11
check [for u in linspace(0, 1, 5): s2(_, 0)(u)] ~= [for u in linspace(0, 1, 5): section0(u)] within 1e-10
check [for u in linspace(0, 1, 5): s2(_, 1)(u)] ~= [for u in linspace(0, 1, 5): section3(u)] within 1e-10
surface s3 = skin([section0, section1, section2, section3], degree = 3)
check s3.knots_v ~= [0, 0, 0, 0, 1, 1, 1, 1] within 1e-11
check s3.points ~= [
  [
    (0, 0, 0),
    (0, 0.93217761060608989, 3.1469004542482809),
    (0, 5.1046194510413286, -2.4085075483648013),
    (0, 6, 1),
  ],
  [
    (1, 0, 2),
    (0.24819644487153105, 3.9205797894800338, 4.8299039034996069),
    (3.7074834466911908, 3.359473260148254, 0.91821516657865201),
    (1, 6, 1),
  ],
  [
    (3, 0, 0),
    (2.2481964448715311, 1.0906758859804269, -0.75180355512846895),
    (5.7074834466911908, 4.441258093569602, 2.7074834466911908),
    (3, 7, 0),
  ],
] within 7e-11
check s3(1/3, 1/2) ~= (1.1852110885200115, 3.2138611565827578, 1.3847942136976254) within 3.21e-11
check s3(0.8, 0.1) ~= (2.1347972375978664, 0.60147074242442288, 0.80827821590367258) within 2.13e-11
check [for u in linspace(0, 1, 5): s3(_, 0)(u)] ~= [for u in linspace(0, 1, 5): section0(u)] within 1e-10
check [for u in linspace(0, 1, 5): s3(_, 1)(u)] ~= [for u in linspace(0, 1, 5): section3(u)] within 1e-10
