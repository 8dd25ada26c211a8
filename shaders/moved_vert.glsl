// SPDX-License-Identifier: GPL-3.0-or-later
// A corner of a picture: where it is seen, and its place on the picture, (0, 0) to (1, 1).

void main()
{
    share = place;
    gl_Position = corner;
}
