// SPDX-License-Identifier: GPL-3.0-or-later
// A single triangle that covers the target.
void main()
{
  gl_Position = vec4(corner, 0.0, 1.0);
}
