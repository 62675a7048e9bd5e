#include "host/mesh/msh/read_msh.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/mesh/mesh_error.hpp"
#include "tests/host/mesh/msh/msh_writer.hpp"

namespace tentpole {
namespace {

using testing::MshWriter;

const MshEncoding text{};
const std::vector<MshEncoding> encodings_2{text, {true, false, 4}, {true, true, 4}};
const std::vector<MshEncoding> encodings_4{text, {true, false, 8}, {true, true, 8}, {true, false, 4}, {true, true, 4}};

void add_names(MshWriter& writer) {
  writer.line("$PhysicalNames").line("3").line("1 7 \"lower side\"").line("2 7 \"plate\"").line("2 8 \"\"");
  writer.line("$EndPhysicalNames");
}

/// A line and two triangles, of which the second is in the nameless group 8; the nodes have scattered labels.
std::string version_2(const MshEncoding& encoding) {
  MshWriter writer(encoding);
  writer.format("2.2");
  add_names(writer);
  writer.line("$Nodes").line("4");
  writer.label(10).numbers({0, 0, 0}).label(2000000000).numbers({1, 0, 0});
  writer.label(3).numbers({1, 0.5, 0}).label(4).numbers({0, 0.5, 0});
  writer.line("").line("$EndNodes").line("$Elements").line("3");
  if (encoding.is_binary) {
    writer.integers({1, 1, 2}).labels({5, 7, 1, 10, 2000000000});
    writer.integers({2, 2, 4}).labels({6, -7, 1, 1, 3, 10, 2000000000, 3}).labels({9, 8, 2, 1, -2, 10, 3, 4});
  } else {
    writer.labels({5, 1, 2, 7, 1, 10, 2000000000});
    writer.labels({6, 2, 4, -7, 1, 1, 3, 10, 2000000000, 3}).labels({9, 2, 4, 8, 2, 1, -2, 10, 3, 4});
  }
  return writer.line("").line("$EndElements").bytes();
}

/// The same mesh. The line and the first triangle lie on entities with the same number.
std::string version_4(const MshEncoding& encoding) {
  MshWriter writer(encoding);
  writer.format("4.1");
  add_names(writer);
  writer.line("$Entities").labels({1, 1, 2, 0});
  writer.integer(1).numbers({0, 0, 0}).label(0);
  writer.integer(1).numbers({0, 0, 0, 1, 0, 0}).label(1).integer(7).label(2).integers({1, -2});
  writer.integer(1).numbers({0, 0, 0, 1, 1, 0}).label(1).integer(-7).label(1).integer(1);
  writer.integer(2).numbers({0, 0, 0, 1, 1, 0}).label(1).integer(8).label(0);
  writer.line("").line("$EndEntities").line("$Nodes").labels({3, 4, 3, 2000000000});
  writer.integers({0, 1, 0}).label(1).label(10).numbers({0, 0, 0});
  writer.integers({1, 1, 1}).label(1).label(2000000000).numbers({1, 0, 0, 0.25});
  writer.integers({2, 1, 1}).label(2).labels({3, 4}).numbers({1, 0.5, 0, 8, 9}).numbers({0, 0.5, 0, 8, 9});
  writer.line("").line("$EndNodes").line("$Elements").labels({3, 3, 5, 9});
  writer.integers({1, 1, 1}).label(1).labels({5, 10, 2000000000});
  writer.integers({2, 1, 2}).label(1).labels({6, 10, 2000000000, 3});
  writer.integers({2, 2, 2}).label(1).labels({9, 10, 3, 4});
  return writer.line("").line("$EndElements").bytes();
}

void expect_the_sample(const MshContents& contents) {
  EXPECT_EQ(contents.node_label, (std::vector<std::int64_t>{10, 2000000000, 3, 4}));
  EXPECT_EQ(contents.node_position, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 0.5, 0}, {0, 0.5, 0}}));
  EXPECT_EQ(contents.element_label, (std::vector<std::int64_t>{5, 6, 9}));
  EXPECT_EQ(contents.element_node, (std::vector<std::int32_t>{0, 1, 0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(contents.name_of(1, 7), "lower side");
  EXPECT_EQ(contents.name_of(2, 7), "plate");
  EXPECT_EQ(contents.name_of(2, 8), "8");
  ASSERT_EQ(contents.blocks.size(), 3u);
  for (std::size_t block = 0; block < 3; ++block) {
    EXPECT_EQ(contents.blocks[block].type->dimension, block == 0 ? 1 : 2);
    EXPECT_EQ(contents.blocks[block].first, block);
    EXPECT_EQ(contents.blocks[block].num_elements, 1u);
    const std::vector<std::int64_t> expected{block == 2 ? 8 : 7};
    if (contents.has_entities)
      EXPECT_EQ(contents.groups.at(contents.blocks[block].entity), expected);
    else
      EXPECT_EQ(contents.blocks[block].group, expected[0]);
  }
}

TEST(ReadMsh, Version2IsTheSameInEveryEncoding) {
  for (const MshEncoding& encoding : encodings_2) expect_the_sample(read_msh("sample", version_2(encoding)));
}

TEST(ReadMsh, Version4IsTheSameInEveryEncoding) {
  for (const MshEncoding& encoding : encodings_4) expect_the_sample(read_msh("sample", version_4(encoding)));
}

TEST(ReadMsh, LinesMayEndAsOnWindows) {
  std::string windows;
  for (const char character : version_4(text))
    windows += character == '\n' ? std::string("\r\n") : std::string(1, character);
  expect_the_sample(read_msh("sample", windows));
}

TEST(ReadMsh, OtherSectionsArePassedOverWhereverTheyStand) {
  const std::string others =
      "$Comments\n$Nodes of nothing\n$EndNodes\n$EndComments\n$Periodic\n1\n$EndPeriodic\n"
      "$GhostElements\n2\n6 1 1 2\n9 2 1 1\n$EndGhostElements\n$Mine\n\x01\x02$EndMin\n$EndMine\n";
  for (const std::string& sample : {version_2(text), version_4(text), version_4(encodings_4[1])}) {
    std::string with_others = sample;
    const std::size_t names = with_others.find("$PhysicalNames");
    with_others.insert(names, others);
    expect_the_sample(read_msh("sample", with_others + others));
  }
}

TEST(ReadMsh, ElementsOfVersion4MayLackEntities) {
  const MshContents contents = read_msh("sample",
                                        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n"
                                        "0. 0. 0.\n+1. 0. 0.\n1e-400 1. 0.\n$EndNodes\n"
                                        "$Elements\n1 1 1 1\n2 1 2 1\n1 1 2 3\n$EndElements\n");
  EXPECT_EQ(contents.element_node, (std::vector<std::int32_t>{0, 1, 2}));
  EXPECT_EQ(contents.node_position[2], (Point{0, 1, 0}));
  EXPECT_TRUE(contents.groups.empty());
}

TEST(ReadMsh, NamesOfVersion20HaveNoDimension) {
  const MshContents contents =
      read_msh("old", "$MeshFormat\n2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 \"wall\"\n$EndPhysicalNames\n");
  EXPECT_EQ(contents.name_of(1, 3), "wall");
}

TEST(ReadMsh, NamesMayHoldQuotationMarks) {
  const MshContents contents = read_msh(
      "sample", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 3 \"a \"b\" c\"\n$EndPhysicalNames\n");
  EXPECT_EQ(contents.name_of(1, 3), "a \"b\" c");
}

/// The message of the refusal, or "accepted".
std::string refusal(const std::string& bytes) {
  try {
    read_msh("sample", bytes);
  } catch (const MeshError& error) {
    return error.what();
  }
  return "accepted";
}

struct Fault {
  std::string from, to;  ///< text of the sample, and what stands there instead
  std::string message;   ///< what the refusal must hold
};

const char* const sample_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 5 \"plate\"\n$EndPhysicalNames\n"
    "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n$Elements\n2\n1 1 2 3 3 1 2\n2 2 2 5 5 1 2 3\n$EndElements\n";
const char* const sample_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 0\n1 0 0 0 1 1 0 1 5 0\n$EndEntities\n"
    "$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n"
    "$Elements\n1 1 2 2\n2 1 2 1\n2 1 2 3\n$EndElements\n";

const std::vector<Fault> faults_2{
    {"2.2 0 8", "1.0 0 8", "line 2, $MeshFormat: the version of the format is 1; only 2.2 and 4.1"},
    {"2.2 0 8", "4 0 8", "the version of the format is 4; only 2.2 and 4.1"},
    {"2.2 0 8", "2.2 7 8", "line 2, $MeshFormat: the file is neither text (0) nor binary (1), but 7"},
    {"$EndMeshFormat", "", "line 4, $MeshFormat: \"$PhysicalNames\" stands where $EndMeshFormat must be"},
    {"1\n2 5", "x\n2 5", "line 5, $PhysicalNames: \"x\" stands where the number of physical names"},
    {"1\n2 5", "3\n2 5",
     "line 7, $PhysicalNames: \"$EndPhysicalNames\" stands where the dimension of a physical group"},
    {"2 5 \"plate\"", "4 5 \"plate\"", "physical group 5 has the dimension 4"},
    {"2 5 \"plate\"", "2 5 plate", "line 6, $PhysicalNames: \"plate\" stands where the name of a physical group"},
    {"2 5 \"plate\"", "2 5 \"plate", "\"\"plate\" stands where the name of a physical group"},
    {"$Nodes\n3", "$Nodes\n2", "line 12, $Nodes: \"3\" stands where $EndNodes must be"},
    {"$Nodes\n3", "$Nodes\n4", "line 13, node 3: \"$EndNodes\" stands where the number of a node"},
    {"$Nodes\n3", "$Nodes\n-1", "line 9, $Nodes: the number of nodes is given as -1"},
    {"$Nodes\n3", "$Nodes\n4000000000000000000", "given as 4000000000000000000, but the rest of the file has room for"},
    {"$Nodes\n3", "$Nodes\n99999999999999999999", "\"99999999999999999999\" stands where the number of nodes"},
    {"2 1 0 0", "2 1 zero 0", "line 11, node 2: \"zero\" stands where a coordinate, a number, must be"},
    {"2 1 0 0", "3 1 0 0", "line 15, node 3: is given twice, at (1, 0, 0) and at (0, 1, 0)"},
    {"2 2 2 5 5 1 2 3", "2 2 2 5 5 1 2 4", "line 17, element 2: its node 4 is not among the 3 nodes"},
    {"2 2 2 5 5 1 2 3", "2 78 2 5 5 1 2 3", "line 17, element 2: its type 78 is none"},
    {"2 2 2 5 5 1 2 3", "2 34 2 5 5 1 2 3", "line 17, element 2: is a Polygon, whose number of nodes varies"},
    {"2 2 2 5 5 1 2 3", "2 2 -2 5 5 1 2 3", "line 17, element 2: -2 tags cannot be"},
    {"2 2 2 5 5 1 2 3", "2 2 2.5 5 5 1 2 3", "line 17, element 2: \"2.5\" stands where the number of tags"},
    {"2 2 2 5 5 1 2 3", "2 2 2 5 5 1 2", "line 18, element 2: \"$EndElements\" stands where a node of the element"},
    {"$EndElements", "", "line 19, $Elements: the file ends where $EndElements must be"},
    {"$EndElements", "$EndElements\n$Comments\n", "line 19, $Comments: is not closed by \"$EndComments\""},
    {"$EndElements", "$EndElements\n$EndNodes\n", "line 19, $EndNodes: ends a section that was not begun"},
    {"$EndElements", "$EndElements\nall right", "line 19: \"all right\" stands between two sections"}};

const std::vector<Fault> faults_4{
    {"0 0 1 0\n1", "0 0 900 0\n1", "line 5, $Entities: a number of entities is given as 900, but"},
    {"1 0 0 0 1 1 0 1 5 0", "1 0 0 0 1 1 0 77777 5 0", "line 6, surface 1: the number of physical groups is given as"},
    {"1 0 0 0 1 1 0 1 5 0", "1 0 0 0 1 1 0 1 5",
     "line 7, surface 1: \"$EndEntities\" stands where the number of bounding"},
    {"$Nodes\n1 3 1 3", "$Nodes\n123456 3 1 3", "line 9, $Nodes: the number of blocks is given as 123456"},
    {"2 1 0 3", "4 1 0 3", "line 10, $Nodes: the dimension of an entity is 4"},
    {"2 1 0 3", "2 1 0 30000", "line 10, $Nodes: the number of nodes of a block is given as 30000"},
    {"2 1 0 3", "2 1 1 3", "line 17, node 2: \"$EndNodes\" stands where a parametric coordinate"},
    {"2 1 2 1\n", "2 1 35 1\n", "line 20, $Elements: is a Polyhedron, whose number of nodes varies"},
    {"2 1 2 1\n", "2 1 2 9\n", "line 20, $Elements: the number of elements of a block is given as 9"},
    {"2 1 2 3\n", "2 1 2 77\n", "line 21, element 2: its node 77 is not among the 3 nodes"}};

void expect_refusals(const std::string& sample, const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    std::string bytes = sample;
    ASSERT_NE(bytes.find(fault.from), std::string::npos) << fault.from;
    bytes.replace(bytes.find(fault.from), fault.from.size(), fault.to);
    const std::string message = refusal(bytes);
    EXPECT_NE(message.find(fault.message), std::string::npos) << "expected \"" << fault.message << "\" in\n" << message;
    EXPECT_EQ(message.rfind("sample", 0), 0u) << message;
  }
}

TEST(ReadMsh, RefusesFaultsWithLineAndEntity) {
  ASSERT_EQ(refusal(sample_2), "accepted");
  ASSERT_EQ(refusal(sample_4), "accepted");
  expect_refusals(sample_2, faults_2);
  expect_refusals(sample_4, faults_4);
}

TEST(ReadMsh, RefusesFaultsOfBinaryFilesWithTheByte) {
  const auto binary_nodes = [](std::int64_t count) {
    MshWriter writer({true, false, 8});
    writer.format("4.1").line("$Nodes").labels({1, count, 1, count}).integers({2, 1, 0}).label(count);
    return writer.label(1).numbers({0, 0, 0}).line("").line("$EndNodes").bytes();
  };
  EXPECT_EQ(refusal(binary_nodes(1)), "accepted");
  const std::string message = refusal(binary_nodes(std::int64_t{1} << 60));
  EXPECT_NE(message.find("sample, byte 91, $Nodes: the number of nodes of a block is given as 1152921504606846976"),
            std::string::npos)
      << message;
  MshWriter list({true, false, 4});
  list.format("2.2").line("$Elements").line("2").integers({2, 0, 2});
  EXPECT_NE(refusal(list.bytes()).find("a list of 0 elements stands where 2 are left"), std::string::npos);
  MshWriter order({true, false, 4});
  order.line("$MeshFormat").line("2.2 1 8").integer(2).line("").line("$EndMeshFormat");
  EXPECT_NE(refusal(order.bytes()).find("byte 20, $MeshFormat: the mark of the byte order is 2"), std::string::npos);
  MshWriter wide({true, false, 4});
  wide.line("$MeshFormat").line("4.1 1 16").integer(1);
  EXPECT_NE(refusal(wide.bytes()).find("numbers of 16 bytes cannot be read"), std::string::npos);
}

TEST(ReadMsh, PrefixesAreRefusedUnlessTheyEndWithASection) {
  std::vector<std::string> samples;
  for (const MshEncoding& encoding : encodings_2) samples.push_back(version_2(encoding));
  for (const MshEncoding& encoding : encodings_4) samples.push_back(version_4(encoding));
  for (const std::string& sample : samples)
    for (std::size_t size = 0; size < sample.size(); ++size) {
      const std::string prefix = sample.substr(0, size);
      const std::size_t last = prefix.rfind('$');
      const bool ends_with_section =
          last != std::string::npos && prefix.compare(last, 4, "$End") == 0 && size >= sample.find('\n', last);
      EXPECT_EQ(refusal(prefix) == "accepted", ends_with_section) << "the first " << size << " bytes";
    }
}

TEST(ReadMsh, EveryChangedByteIsReadOrRefused) {
  for (const std::string& sample :
       {version_2(text), version_2(encodings_2[1]), version_4(text), version_4(encodings_4[1])})
    for (std::size_t at = 0; at < sample.size(); ++at)
      for (const char change : {'\0', '\x7f', '\xff', '-', '9', ' ', '\n', '$'}) {
        std::string changed = sample;
        changed[at] = change;
        EXPECT_NE(refusal(changed), "");  // any other exception fails the test
      }
}

}  // namespace
}  // namespace tentpole
