// SPDX-License-Identifier: GPL-3.0-or-later
// Bands of lines (native/fovea/elision/bands.h); higher ranks are nearer.
void main()
{
  float depth = owner.z / (most_rank + 1.0);
  gl_Position = vec4((px - buffer_origin) / buffer_size * 2.0 - 1.0, depth * 2.0 - 1.0, 1.0);
  place = across;
  line_owner = owner;
}
