// Lists whose copies share their values, and that find them by name.
#include "lessons/shared_list.h"

#include <gtest/gtest.h>

#include <vector>

namespace halfspace {
namespace {

using Numbers = SharedList<int>;

struct Named {
  std::string name;
  int value = 0;
  bool operator==(const Named &) const = default;
};
using Names = NamedList<Named>;

/// Whether each name is found where it stands, and no other is.
bool findsAll(const Names &list) {
  for (std::size_t place = 0; place < list.size(); ++place)
    if (list.placeOf(list[place].name) != place || list.find(list[place].name) != &list[place])
      return false;
  return !list.find("nobody") && !list.find("");
}

TEST(SharedList, Copied_SharesItsValues_AndKeepsThemWhenTheOtherChanges) {
  const Numbers list{1, 2, 3};
  Numbers copy = list;
  EXPECT_EQ(&copy[1], &list[1]);
  copy.replace(1, 5);
  EXPECT_EQ(copy, (Numbers{1, 5, 3}));
  EXPECT_EQ(list, (Numbers{1, 2, 3}));
  EXPECT_EQ(&copy[0], &list[0]);
  EXPECT_EQ(&copy[2], &list[2]);
}

TEST(SharedList, Changed_IsAnotherListThanItsCopy_WhateverIsDone) {
  const Numbers list{1, 2, 3};
  const auto changed = [&](auto change) {
    Numbers copy = list;
    change(copy);
    EXPECT_EQ(list, (Numbers{1, 2, 3}));
    return copy;
  };
  EXPECT_EQ(changed([](Numbers &copy) { copy.push_back(4); }), (Numbers{1, 2, 3, 4}));
  EXPECT_EQ(changed([](Numbers &copy) { copy.pop_back(); }), (Numbers{1, 2}));
  EXPECT_EQ(changed([](Numbers &copy) { copy.insert(1, 7); }), (Numbers{1, 7, 2, 3}));
  EXPECT_EQ(changed([](Numbers &copy) { copy.erase(0); }), (Numbers{2, 3}));
  EXPECT_EQ(changed([](Numbers &copy) { copy.append(copy); }), (Numbers{1, 2, 3, 1, 2, 3}));
  EXPECT_EQ(changed([](Numbers &copy) { copy.change(2, [](int &value) { ++value; }); }), (Numbers{1, 2, 4}));
  EXPECT_EQ(changed([](Numbers &copy) { copy.eraseIf([](int value) { return value != 2; }); }), (Numbers{2}));
}

TEST(SharedList, WithoutValues_IsEmpty_AndEqualToOneThatLostThem) {
  Numbers list{1};
  list.pop_back();
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(list, Numbers());
  EXPECT_EQ(Numbers().begin(), Numbers().end());
}

TEST(SharedList, WhoseValuesAreEqual_IsEqual_ThoughItSharesNone) {
  EXPECT_EQ((Numbers{1, 2}), (Numbers{1, 2}));
  EXPECT_NE((Numbers{1, 2}), (Numbers{1, 3}));
  EXPECT_NE((Numbers{1, 2}), (Numbers{1}));
}

TEST(SharedList, GoneThrough_HasItsValuesInOrder_BothWays) {
  const Numbers list{1, 2, 3};
  EXPECT_EQ(std::vector<int>(list.begin(), list.end()), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(std::vector<int>(list.rbegin(), list.rend()), (std::vector<int>{3, 2, 1}));
  EXPECT_EQ(list.end() - list.begin(), 3);
  EXPECT_EQ(list.begin()[2], 3);
}

TEST(SharedList, AppendedToAnother_SharesItsValuesWithIt) {
  const Numbers more{4, 5};
  Numbers list{1};
  list.append(more);
  EXPECT_EQ(list, (Numbers{1, 4, 5}));
  EXPECT_EQ(&list[2], &more[1]);
}

TEST(NamedList, AfterEverySortOfChange_FindsEachNameWhereItStands) {
  Names list{{"a", 1}, {"b", 2}};
  const Names before = list;
  list.push_back({"c", 3});
  EXPECT_TRUE(findsAll(list));
  list.insert(0, {"d", 4});
  EXPECT_TRUE(findsAll(list));
  list.erase(1);
  EXPECT_TRUE(findsAll(list));
  EXPECT_EQ(list.find("a"), nullptr);
  list.change(0, [](Named &value) { value.name = "e"; });
  EXPECT_TRUE(findsAll(list));
  EXPECT_EQ(list.find("d"), nullptr);
  list.replace(1, {"f", 6});
  EXPECT_TRUE(findsAll(list));
  list.eraseIf([](const Named &value) { return value.name == "e"; });
  EXPECT_TRUE(findsAll(list));
  EXPECT_EQ(list, (Names{{"f", 6}, {"c", 3}}));
  EXPECT_TRUE(findsAll(before));
  EXPECT_EQ(before, (Names{{"a", 1}, {"b", 2}}));
}

TEST(NamedList, OfSeveralWithOneName_FindsTheFirst) {
  Names list{{"a", 1}, {"a", 2}};
  EXPECT_EQ(list.find("a")->value, 1);
  list.push_back({"a", 3});
  EXPECT_EQ(list.find("a")->value, 1);
  list.erase(0);
  EXPECT_EQ(list.find("a")->value, 2);
}

} // namespace
} // namespace halfspace
