// Hsu: Circle by the incremental form ((9)-(11), Assignment 3)
geo 1
let hub = (1, 2)
let radius = 5
fn advance(q, delta, n) = if n == 0 then q else advance(
  hub + (cos(delta)*(q.x - hub.x) - sin(delta)*(q.y - hub.y), sin(delta)*(q.x - hub.x) + cos(delta)*(q.y - hub.y)), delta, n - 1)
check advance(hub + (radius, 0), pi/6, 1) ~= (5.3301270189221932, 4.5, 0) within 1e-11
check hub + polar(radius, 1rad*1*pi/6) ~= (5.3301270189221932, 4.5, 0) within 1e-11
check advance(hub + (radius, 0), pi/6, 2) ~= (3.5, 6.3301270189221932, 0) within 1e-11
check hub + polar(radius, 1rad*2*pi/6) ~= (3.5, 6.3301270189221932, 0) within 1e-11
check advance(hub + (radius, 0), pi/6, 12) ~= (6, 2, 0) within 1e-11
check hub + polar(radius, 1rad*12*pi/6) ~= (6, 2, 0) within 1e-11
check advance(hub + (radius, 0), pi/18, 1) ~= (5.9240387650610403, 2.8682408883346517, 0) within 1e-11
check hub + polar(radius, 1rad*1*pi/18) ~= (5.9240387650610403, 2.8682408883346517, 0) within 1e-11
check advance(hub + (radius, 0), pi/18, 2) ~= (5.6984631039295419, 3.7101007166283437, 0) within 1e-11
check hub + polar(radius, 1rad*2*pi/18) ~= (5.6984631039295419, 3.7101007166283437, 0) within 1e-11
check advance(hub + (radius, 0), pi/18, 36) ~= (6, 2, 0) within 1e-11
check hub + polar(radius, 1rad*36*pi/18) ~= (6, 2, 0) within 1e-11
check advance(hub + (radius, 0), 1/10, 1) ~= (5.9750208263901288, 2.4991670832341408, 0) within 1e-11
check hub + polar(radius, 1rad*1*1/10) ~= (5.9750208263901288, 2.4991670832341408, 0) within 1e-11
check advance(hub + (radius, 0), 1/10, 2) ~= (5.9003328892062082, 2.9933466539753061, 0) within 1e-11
check hub + polar(radius, 1rad*2*1/10) ~= (5.9003328892062082, 2.9933466539753061, 0) within 1e-11
check advance(hub + (radius, 0), 1/10, 20) ~= (-1.0807341827357119, 6.5464871341284085, 0) within 1e-11
check hub + polar(radius, 1rad*20*1/10) ~= (-1.0807341827357119, 6.5464871341284085, 0) within 1e-11
