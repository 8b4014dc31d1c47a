# style: complex numbers

import cmath

end = complex(x, y) + cmath.rect(reading, math.radians(90 - angle))
end_x, end_y = end.real, end.imag
