// A pinhole camera: the pixel of the screen in which a point of the world is seen from the eye, and the ray
// from the eye through the centre of that pixel.
#include "geometry/intersect_ray_triangle.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/screen.h"
#include "lessons/term/prime.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PointObject> Q;
  Given<ScreenObject> S;
  Given<PointObject> X;
};

/// Where the ray from the eye to the point meets the screen, as if that were twice a triangle.
RayTriangle<Rational> meetingOf(const In &in) {
  const auto &[corner, u, v, w, h] = in.S.object;
  return intersectRayTriangle(Ray<Rational>{in.Q.object.at, ExactVec3(in.X.object.at - in.Q.object.at)},
                              Triangle<Rational>{corner, ExactVec3(corner + u), ExactVec3(corner + v)});
}

struct Out : Computed<In>, ScreenTerms {
  explicit Out(const In &objects) : Computed(objects), ScreenTerms(termsOf(objects.S)) {}

  const ScreenObject &screen = in.S.object;
  const ExactVec3 &eye = in.Q.object.at;
  RayTriangle<Rational> meet = meetingOf(in);
  const ExactVec3 &normal = meet.perps.normal;
  bool isScreen = meet.perps.denominator != 0;
  bool isRectangle = meet.perps.uv == 0;
  // How deep the screen and X lie before the eye, along n, times |n|:
  Rational screenDepth = dot(ExactVec3(screen.corner - eye), normal);
  Rational pointDepth = dot(ExactVec3(in.X.object.at - eye), normal);
  bool isCamera = isScreen && screenDepth != 0;
  bool hasImage = isCamera && pointDepth != 0;
  bool isAhead = hasImage && meet.plane.t > 0;
  Rational across = meet.s * screen.w;       ///< from the corner to the image along u, in pixels
  Rational down = meet.tTriangle * screen.h; ///< and along v
  Rational column = floorOf(across);
  Rational row = floorOf(down);
  /// Whether a pixel shows X. A point on the line between two pixels belongs to the later one.
  bool isSeen = isAhead && column >= 0 && column < screen.w && row >= 0 && row < screen.h;
  ExactVec3 pixel = isSeen ? screen.at(column, row) : ExactVec3(0);
  ExactVec3 centre = isSeen ? screen.at(column + Rational(1, 2), row + Rational(1, 2)) : ExactVec3(0);
  Rational reach = isSeen ? Rational(1 / meet.plane.t) : Rational(0); ///< to X in steps r
  ExactVec3 passing = eye + ExactVec3(centre - eye) * reach;
  bool isThrough = isSeen && passing == in.X.object.at; ///< whether the pixel's ray goes through X

  Term Q = termOf(in.Q);
  Term X = termOf(in.X);
  Term n = drawnName(vectorLetter("n"), normal);
  Term k = ownName(letter("k"), meet.plane.t);
  Term image = ownName(primed(in.X.symbol), meet.plane.point).marked(mark("image"));
  Term p = drawnName(letter("p"), across);
  Term q = drawnName(letter("q"), down);
  Term i = ownName(letter("i"), column).marked(mark("pixel"));
  Term j = ownName(letter("j"), row).marked(mark("pixel"));
  Term A = drawnName(letter("A"), pixel);
  Term C = drawnName(letter("C"), centre);
  Term r = madeName("L", "r", ExactVec3(centre - eye));
  Term t = ownName(letter("t"), reach);
  Term H = drawnName(letter("H"), passing);
  Term patch = (t * (norm(u) / w)).marked(mark("patch"));
};

CaseWords tell(const Out &at) {
  if (!at.isScreen)
    return {"no-screen",
            words("{u} and {v} lie along one line, or one of them is the zero vector: they span no screen.",
                  at.letters),
            true};
  if (!at.isCamera)
    return {"eye-in-screen",
            words("{Q} lies in the plane of the screen: from there the screen is only a line.", at.letters),
            true};
  if (!at.hasImage)
    return {"level", at.eye == at.in.X.object.at
                         ? words("{X} is at the eye itself: no line of sight leads to it.", at.letters)
                         : words("({X} − {Q})·n = 0: the line of sight runs parallel to the screen and "
                                 "never meets its plane. {X} has no image.",
                                 at.letters)};
  if (!at.isAhead)
    return {"behind", words("{k} is negative: {X} is behind the eye, and is not seen.", at.letters,
                            {{"k", equation(at.k)}})};
  if (!at.isSeen)
    return {"beside",
            words("The line of sight passes beside all pixels: {X} is not in the image.", at.letters)};
  return {"seen", words("{X} is seen in the pixel with {i} and {j}.", at.letters,
                        {{"i", equation(at.i)}, {"j", equation(at.j)}})};
}

std::string shareWords(const Out &at) {
  const Rational &k = at.meet.plane.t;
  return k < 0   ? words("Negative: from {Q}, the screen and {X} lie on opposite sides.", at.letters)
         : k < 1 ? words("This part of the way from {Q} to {X} leads to the plane of the screen.", at.letters)
         : k == 1 ? words("1: {X} lies in the plane of the screen.", at.letters)
                  : words("Larger than 1: {X} is between the eye and the plane of the screen.", at.letters);
}

std::string imageWords(const Out &at) {
  return at.isAhead
             ? words("The image of {X}: here the line of sight meets the plane of the screen.", at.letters)
             : words("Only the line backwards from {Q} meets the plane of the screen here.", at.letters);
}

/// How many pixels lead to the image along an edge. Where the edges make no right angle, the vector across
/// the other one takes the edge's place.
WorkingLine pixelsLine(const Out &at, const Term &count, const Term &edge, const Term &other,
                       const Term &pixels) {
  const Term way = at.image - at.P0;
  if (at.isRectangle)
    return asked(withNumbers(count == pixels * (dot(way, edge) / dot(edge, edge))),
                 words("How far the image lies from {P0} along {edge}, in pixels.", at.letters,
                       {{"edge", plainText(edge)}}),
                 {{dot(way, edge) / dot(edge, edge),
                   words("{answer} is the part of the whole edge: multiply it by {pixels}.",
                         {{"pixels", plainText(pixels)}})},
                  {pixels * (dot(way, edge) / norm(edge)),
                   words("{answer} is divided by |{edge}| once: divide by {edge}·{edge}.",
                         {{"edge", plainText(edge)}})}});
  const Term blind = cross(other, at.n);
  return asked(withNumbers(count == pixels * (dot(way, blind) / dot(edge, blind))),
               words("The edges make no right angle, so a vector perpendicular to {other} takes the place of "
                     "{edge}.",
                     {{"other", plainText(other)}, {"edge", plainText(edge)}}));
}

/// The number of a pixel's column or row: i = floor(p).
WorkingLine floorLine(const Term &number, const Term &count, const Rational &value) {
  const Term floored = applied(word("floor"), list({count}), value);
  return asked(withResult(number == floored), words("The whole pixels before it. Counting begins with 0."),
               {{count, words("{answer} still has its fraction: cut it off.")},
                {floored + 1, words("{answer} counts from 1: the first pixel has the number 0.")}});
}

WorkingLine cornerLine(const Out &at) {
  return asked(withNumbers(at.A == at.P0 + (at.i / at.w) * at.u + (at.j / at.h) * at.v),
               words("The corner where the pixel begins."));
}

WorkingLine centreLine(const Out &at) {
  const Rational half(1, 2);
  return asked(
      withNumbers(at.C == at.P0 + ((at.i + half) / at.w) * at.u + ((at.j + half) / at.h) * at.v),
      words("The centre: half a pixel further in both directions."),
      {{at.A, words("{answer} is the corner where the pixel begins: add half a pixel to {i} and to {j}.",
                    {{"i", plainText(at.i)}, {"j", plainText(at.j)}})},
       {at.P0 + ((at.i + 1) / at.w) * at.u + ((at.j + 1) / at.h) * at.v,
        words("{answer} is the corner where the pixel ends: add only half a pixel.")}});
}

WorkingLine directionLine(const Out &at) {
  return asked(withNumbers(at.r == at.C - at.Q), words("From the eye to the centre of the pixel."),
               {{at.Q - at.C, words("{answer} leads back to the eye: take {Q} away from C.", at.letters)}});
}

std::string passingWords(const Out &at) {
  return at.isThrough
             ? words("This is {X} itself: {X} is seen exactly in the centre of the pixel.", at.letters)
             : words("Here the pixel's ray passes by {X}.", at.letters);
}

LineTable<Out> lines() {
  return {
      {"n", &Out::isScreen, [](const Out &at) { return withProducts(at.n == cross(at.u, at.v)); },
       says("Perpendicular to the screen.")},
      {"k", &Out::hasImage,
       [](const Out &at) { return withNumbers(at.k == dot(at.P0 - at.Q, at.n) / dot(at.X - at.Q, at.n)); },
       shareWords},
      {"image", &Out::hasImage,
       [](const Out &at) { return withNumbers(at.image == at.Q + at.k * (at.X - at.Q)); }, imageWords},
      {"p", &Out::hasImage, [](const Out &at) { return pixelsLine(at, at.p, at.u, at.v, at.w); }},
      {"q", &Out::hasImage, [](const Out &at) { return pixelsLine(at, at.q, at.v, at.u, at.h); }},
      {"column", &Out::isSeen, [](const Out &at) { return floorLine(at.i, at.p, at.column); }},
      {"row", &Out::isSeen, [](const Out &at) { return floorLine(at.j, at.q, at.row); }},
      {"corner", &Out::isSeen, cornerLine},
      {"centre", &Out::isSeen, centreLine},
      {"direction", &Out::isSeen, directionLine},
      {"t", &Out::isSeen, [](const Out &at) { return withNumbers(at.t == 1 / at.k); },
       says("It takes this many steps to get to the plane through {X} that is parallel to the screen.")},
      {"passing", &Out::isSeen, [](const Out &at) { return withNumbers(at.H == at.Q + at.t * at.r); },
       passingWords},
      {"patch", &Out::isSeen, [](const Out &at) { return withNumbers(at.patch); },
       says("How wide a piece of the plane through {X}, parallel to the screen, the pixel shows.")}};
}

/// The corners of so many columns and rows of pixels, from a pixel on.
std::vector<ExactVec3> cornersOf(const ScreenObject &screen, const Rational &column, const Rational &row,
                                 const Rational &columns, const Rational &rows) {
  return {screen.at(column, row), screen.at(column + columns, row), screen.at(column + columns, row + rows),
          screen.at(column, row + rows)};
}

/// What the screen shows lies between the lines from the eye to its corners.
void drawView(Figure &figure, const Out &at) {
  const std::vector<ExactVec3> corners = cornersOf(at.screen, 0, 0, at.screen.w, at.screen.h);
  for (std::size_t i = 0; i < corners.size(); ++i)
    figure.add(SegmentMark{
        {partOf(at.mark("view"), i), Role::Ghost, Subject::Neutral}, place(at.Q), place(corners[i])});
}

/// The pixel, its ray, and what it shows in the plane through X that is parallel to the screen.
void drawPixel(Figure &figure, const Out &at) {
  std::vector<Place> pixel;
  std::vector<Place> patch;
  for (const ExactVec3 &corner : cornersOf(at.screen, at.column, at.row, 1, 1)) {
    pixel.push_back(place(corner));
    patch.push_back(place(ExactVec3(at.eye + ExactVec3(corner - at.eye) * at.reach)));
  }
  figure.add(PolygonMark{{at.mark("pixel"), Role::Result, Subject::Ray}, std::move(pixel)});
  figure.add(PolygonMark{{at.mark("patch"), Role::Helper, Subject::Ray}, std::move(patch)});
  figure.add(pointOf(at.A, Role::Derived, Subject::Ray));
  figure.add(pointOf(at.C, Role::Derived, Subject::Ray));
  RayMark ray{{at.mark("L"), Role::Derived, Subject::Ray}, place(at.Q), unitOf(vectorOf(at.r))};
  ray.meets = place(at.H);
  figure.add(std::move(ray));
  figure.add(arrowOf(at.r, place(at.Q), Role::Derived, Subject::Ray));
  figure.add(pointOf(at.H, Role::Derived, Subject::Ray));
}

/// The line of sight, and the image with its ways from two edges.
void drawImage(Figure &figure, const Out &at) {
  const Place corner = place(at.P0);
  const Place image = place(at.image);
  const Look &look = at.in.X.look;
  const bool isBetween = at.isAhead && at.meet.plane.t > 1; // the line goes on to the screen
  figure.add(inLook(look, SegmentMark{{at.mark("sight"), Role::Helper, Subject::Point},
                                      place(at.Q),
                                      isBetween ? image : place(at.X)}));
  if (!at.isAhead)
    figure.add(inLook(
        look,
        SegmentMark{{at.mark("sight") + "/backward", Role::Ghost, Subject::Point}, place(at.Q), image}));
  figure.add(inLook(look, pointOf(at.image, at.isSeen ? Role::Result : Role::Ghost, Subject::Point)));
  if (at.across != 0)
    figure.add(SegmentMark{drawn(at.p, Role::Derived, Subject::EdgeU),
                           corner + place(at.v) * toDouble(at.meet.tTriangle), image});
  if (at.down != 0)
    figure.add(SegmentMark{drawn(at.q, Role::Derived, Subject::EdgeV),
                           corner + place(at.u) * toDouble(at.meet.s), image});
}

/// The normal may be very long: it is drawn so long, because only its direction matters.
constexpr double drawnNormalLength = 2;

Figure draw(const Out &at) {
  Figure figure;
  if (at.isScreen)
    addDirection(figure, at.n, place(at.P0), drawnNormalLength, Role::Derived, Subject::Plane);
  if (at.isCamera)
    drawView(figure, at);
  if (at.hasImage)
    drawImage(figure, at);
  if (at.isSeen)
    drawPixel(figure, at);
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.isCamera)
    return all;
  const auto shift = [&](const Rational &depth) { // along n, by a depth times |n|
    return ExactVec3(at.normal * Rational(depth / dot(at.normal, at.normal)));
  };
  all.push_back({is("case", "eye-in-screen"), words("{Q} would lie in the plane of the screen.", at.letters),
                 "Q", PointObject{ExactVec3(at.eye + shift(at.screenDepth))}});
  if (at.hasImage) {
    const ExactVec3 level = at.in.X.object.at - shift(at.pointDepth);
    all.push_back({is("case", "level"),
                   level == at.eye ? words("{X} would be at the eye itself.", at.letters)
                                   : words("The line of sight would run parallel to the screen."),
                   "X", PointObject{level}});
  }
  if (at.isSeen && !at.isThrough)
    all.push_back({is("through", "yes"), words("The pixel's ray would go exactly through {X}.", at.letters),
                   "X", PointObject{at.passing}});
  return all;
}

ValueTable<Out> values() {
  return {{named::vector("normal"), &Out::isScreen, &Out::n},
          {named::number("k"), &Out::hasImage, &Out::k},
          {named::vector("image"), &Out::hasImage, &Out::image},
          {named::number("p"), &Out::hasImage, &Out::p},
          {named::number("q"), &Out::hasImage, &Out::q},
          {named::number("column"), &Out::isSeen, &Out::i},
          {named::number("row"), &Out::isSeen, &Out::j},
          {named::vector("corner"), &Out::isSeen, &Out::A},
          {named::vector("centre"), &Out::isSeen, &Out::C},
          {named::vector("direction"), &Out::isSeen, &Out::r},
          {named::number("t"), &Out::isSeen, &Out::t},
          {named::vector("passing"), &Out::isSeen, &Out::H},
          {named::word("through", {"yes", "no"}), &Out::isSeen,
           [](const Out &at) {
             return ToldValue(words("the pixel's ray goes through {X}", at.letters), yesOrNo(at.isThrough));
           }},
          {named::number("patch"), &Out::isSeen, [](const Out &at) {
             return ToldValue(words("width of what the pixel shows"), listed({}, at.patch).value);
           }}};
}

} // namespace

Construction camera_ray() {
  return taught<Out, PointObject, ScreenObject, PointObject>(
      {.id = "camera-ray",
       .title = [] { return words("ray of the eye through the screen"); },
       .roles = {"Q", "S", "X"},
       .makes = {{"L", RayObject::kind, &Out::isSeen,
                  [](const Out &at) {
                    return RayObject{at.eye, vectorOf(at.r)};
                  }}},
       .letters = {"n", "k", "p", "q", "i", "j", "A", "C", "t", "H"},
       .cases = {"seen", "beside", "behind", "level", "eye-in-screen", "no-screen"},
       .values = values(),
       .lines = lines(),
       .marks = {"n", "view", "sight", "image", "p", "q", "pixel", "patch", "A", "C", "L", "L.r", "H"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
