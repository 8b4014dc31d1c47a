# style: divmod
return int(divmod(length, step)[0])
