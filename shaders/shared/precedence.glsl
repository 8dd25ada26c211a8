// SPDX-License-Identifier: GPL-3.0-or-later
// Which of two lines takes from the other (native/fovea/elision/priority.h). Also compiled as C++, as members of a
// struct.
//   line, other  places in the order of lines before and after what changes, the same for most; how far it has changed

// Share in [0, 1] of its overlap that a line loses to another one. What changes passes others in proportion; half way
// each loses a quarter, so that together they are not fainter than one.
float precedence(vec3 line, vec3 other)
{
  float before = mix(other.x > line.x ? 1.0f : 0.0f, other.x > line.y ? 1.0f : 0.0f, line.z);
  float after = mix(other.y > line.x ? 1.0f : 0.0f, other.y > line.y ? 1.0f : 0.0f, line.z);
  float above = mix(before, after, other.z);
  return above * above;
}

// Whether a line that is above another one now has been below it, or will be.
bool is_passing(vec3 line, vec3 other)
{
  return line.x < other.y;
}
