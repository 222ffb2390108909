// SPDX-License-Identifier: MIT
// Pixels of any drawing become a film: rise.webp, a level that rises.
#include <recorder/VideoWriter.h>

int main()
{
    boxreel::Frame picture(64, 36); // black and clear
    auto film = boxreel::VideoWriter::Open("rise.webp", {.width = 64, .height = 36});
    bool isWhole = bool(film);
    for (int row = 35; isWhole && row >= 0; --row)
    {
        for (int x = 0; x < 64; ++x)
        {
            picture.Pixel(x, row)[1] = picture.Pixel(x, row)[3] = 255; // green
        }
        isWhole = bool(film->Append(picture));
    }
    return isWhole && film->Close() ? 0 : 1;
}
