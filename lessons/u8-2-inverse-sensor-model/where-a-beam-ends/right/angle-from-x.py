# style: an angle from the x axis, and a list

a = math.radians(angle)
end_x = x + reading * math.cos(a)
end_y = y + reading * math.sin(a)
