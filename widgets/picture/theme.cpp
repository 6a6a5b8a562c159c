#include "widgets/picture/theme.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

constexpr Color hex(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16 & 0xff), static_cast<std::uint8_t>(rgb >> 8 & 0xff),
          static_cast<std::uint8_t>(rgb & 0xff)};
}

Theme light() {
  Theme theme;
  theme.name = "light";
  theme.backgroundBottom = hex(0xffffff);
  theme.backgroundTop = hex(0xeef3f8);
  theme.ink = hex(0x1b2530);
  theme.mutedInk = hex(0x5a6672);
  theme.panel = hex(0xfbfcfd);
  theme.border = hex(0xd6dde4);
  theme.accent = hex(0x0a66b7);
  theme.warning = hex(0xb3261e);
  theme.grid = hex(0xdbe2ea);
  theme.gridMajor = hex(0xb4c0cc);
  theme.axis = hex(0x7d8995);
  theme.shadow = hex(0xd9dee4);
  theme.halo = hex(0xffffff);
  theme.planeFace = hex(0x56b4e9);
  theme.solids = {hex(0x46525e), hex(0x0072b2), hex(0xd55e00), hex(0xb87d00),
                  hex(0x009e73), hex(0x7a5195), hex(0xc0689b), hex(0x9e3f34)};
  theme.inks = {hex(0x1b2530), hex(0x00629a), hex(0xb34f00), hex(0x8a6000),
                hex(0x007a59), hex(0x6b4585), hex(0xa3447a), hex(0x8f382e)};
  return theme;
}

Theme dark() {
  Theme theme;
  theme.name = "dark";
  theme.backgroundBottom = hex(0x14191f);
  theme.backgroundTop = hex(0x232c36);
  theme.ink = hex(0xeef3f8);
  theme.mutedInk = hex(0xa3b0bd);
  theme.panel = hex(0x1b222a);
  theme.border = hex(0x35414d);
  theme.accent = hex(0x6db7ff);
  theme.warning = hex(0xff7a70);
  theme.grid = hex(0x2c3743);
  theme.gridMajor = hex(0x4a5a6a);
  theme.axis = hex(0x6f7d8b);
  theme.shadow = hex(0x0e1216);
  theme.halo = hex(0x14191f);
  theme.planeFace = hex(0x56b4e9);
  theme.solids = {hex(0xaab8c6), hex(0x8fd0ff), hex(0xff8c42), hex(0xf0c23c),
                  hex(0x2fd6a4), hex(0xc8a2ff), hex(0xf0a0cc), hex(0xe08a7c)};
  theme.inks = theme.solids;
  theme.inks[0] = theme.ink;
  return theme;
}

Theme print() {
  Theme theme = light();
  theme.name = "print";
  theme.backgroundTop = hex(0xffffff);
  theme.ink = hex(0x000000);
  theme.mutedInk = hex(0x404040);
  theme.panel = hex(0xffffff);
  theme.border = hex(0xb0b0b0);
  theme.grid = hex(0xe2e2e2);
  theme.gridMajor = hex(0xbebebe);
  theme.axis = hex(0x707070);
  theme.shadow = hex(0xe0e0e0);
  theme.planeOpacity = 0.24;
  theme.polygonOpacity = 0.30;
  theme.solids[0] = hex(0x202020);
  theme.inks.fill(theme.ink);
  return theme;
}

Theme projector() {
  Theme theme = light();
  theme.name = "projector";
  theme.backgroundTop = hex(0xffffff);
  theme.ink = hex(0x000000);
  theme.mutedInk = hex(0x33404c);
  theme.panel = hex(0xffffff);
  theme.border = hex(0x8a96a2);
  theme.accent = hex(0x0050a0);
  theme.grid = hex(0xcbd4dd);
  theme.gridMajor = hex(0x93a1af);
  theme.axis = hex(0x5f6c79);
  theme.shadow = hex(0xccd3da);
  theme.planeOpacity = 0.36;
  theme.polygonOpacity = 0.42;
  theme.lineScale = 1.4;
  theme.textScale = 1.3;
  theme.solids = {hex(0x1b2530), hex(0x005a94), hex(0xc04f00), hex(0xb87a00),
                  hex(0x008560), hex(0x673c86), hex(0xb4508a), hex(0x8c3328)};
  theme.inks = {hex(0x000000), hex(0x004a7c), hex(0x963f00), hex(0x6e4c00),
                hex(0x006047), hex(0x553070), hex(0x8a2f63), hex(0x7c2c22)};
  return theme;
}

std::uint8_t mixChannel(std::uint8_t a, std::uint8_t b, double t) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * std::clamp(t, 0.0, 1.0)));
}

} // namespace

Color mix(Color a, Color b, double t) {
  return {mixChannel(a.red, b.red, t), mixChannel(a.green, b.green, t), mixChannel(a.blue, b.blue, t)};
}

Color Theme::colorOf(Hue hue) const { return solids.at(static_cast<std::size_t>(hue)); }

Color Theme::inkOf(Hue hue) const { return inks.at(static_cast<std::size_t>(hue)); }

const std::vector<Theme> &themes() {
  static const std::vector<Theme> all{light(), dark(), print(), projector()};
  return all;
}

const Theme *findTheme(std::string_view name) {
  for (const Theme &theme : themes())
    if (theme.name == name)
      return &theme;
  return nullptr;
}

} // namespace halfspace
