// A correct model, made wrong in one way at a time, with the message for each way.
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/fuzzy/error.h"
#include "elsie/fuzzy/fcl.h"

#include "places.h"

using elsie::fuzzy::FclError;
using elsie::fuzzy::parse_fcl;
using elsie::fuzzy::read_fcl;

namespace {

constexpr const char* kModel = R"(FUNCTION_BLOCK drive

VAR_INPUT
  range : REAL;
  azimuth : REAL;
END_VAR

VAR_OUTPUT
  speed : REAL;
END_VAR

FUZZIFY range
  RANGE := (0 .. 1);
  TERM near := (0, 1) (0.5, 0);
  TERM far := (0.2, 0) (1, 1);
END_FUZZIFY

FUZZIFY azimuth
  RANGE := (-90 .. 90);
  TERM left := (-45, 0) (45, 1);
  TERM right := (-45, 1) (45, 0);
END_FUZZIFY

DEFUZZIFY speed
  RANGE := (-20 .. 30);
  TERM back := (-20, 0) (-10, 1) (0, 0);
  TERM fast := (10, 0) (20, 1) (30, 0);
  METHOD : COG;
  DEFAULT := 0;
END_DEFUZZIFY

RULEBLOCK rules
  AND : MIN;
  ACT : MIN;
  ACCU : MAX;
  RULE 1 : IF range IS far OR azimuth IS left THEN speed IS fast;
  RULE 2 : IF range IS near AND azimuth IS right THEN speed IS back;
END_RULEBLOCK

END_FUNCTION_BLOCK
)";

struct Edit {
  std::string from;  // empty: the whole text
  std::string to;
};

struct Mistake {
  std::string what;
  std::vector<Edit> edits;
  std::vector<std::string> messages;  // each "line: sentence"
};

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> kAll = {
      {"a number with a letter in it",
       {{"(0.5, 0)", "(0.5x, 0)"}},
       {"14: '0.5x' is not a number. Numbers are written like 2, 0.25 or 1.5e-3."}},
      {"a number with two points",
       {{"(0.5, 0)", "(0.5.1, 0)"}},
       {"14: '0.5.1' is not a number. Numbers are written like 2, 0.25 or 1.5e-3."}},
      {"a number with digits set apart",
       {{"DEFAULT := 0", "DEFAULT := 1_000"}},
       {"29: '1_000' is not a number. Numbers are written like 2, 0.25 or 1.5e-3."}},
      {"a number out of reach",
       {{"DEFAULT := 0", "DEFAULT := 1e999"}},
       {"29: The number 1e999 is out of reach: numbers go from -1e100 to 1e100, and those nearer "
        "to zero than 1e-307 are zero. Write another one."}},
      {"a decimal comma in a single number",
       {{"DEFAULT := 0", "DEFAULT := 0,5"}},
       {"29: Expected ';' at the end of the DEFAULT statement, after '0', found ','."}},
      {"not a number",
       {{"(0.5, 0)", "(nan, 0)"}},
       {"14: Found 'nan', expected the x of a point, a number."}},
      {"a character without meaning",
       {{"METHOD : COG", "METHOD = COG"}},
       {"28: Found '=', which has no meaning in FCL. Remove it.",
        "28: Found 'COG', expected ':' after METHOD."}},
      {"a comment without end",
       {{"METHOD : COG;", "METHOD : COG; (* centre of gravity"}},
       {"28: The comment that begins here is never closed. Close it with '*)'.",
        "41: Found the end of the file, but the DEFUZZIFY that begins in line 24 is not closed. "
        "Write END_DEFUZZIFY before it.",
        "41: The file ends before END_FUNCTION_BLOCK. Is it complete?"}},
      {"a C comment without end",
       {{"METHOD : COG;", "METHOD : COG; /* centre of gravity"}},
       {"28: The comment that begins here is never closed. Close it with '*/'.",
        "41: Found the end of the file, but the DEFUZZIFY that begins in line 24 is not closed. "
        "Write END_DEFUZZIFY before it.",
        "41: The file ends before END_FUNCTION_BLOCK. Is it complete?"}},
      {"an empty file", {{"", ""}}, {"1: The file has no statements. Expected FUNCTION_BLOCK."}},
      {"only a comment",
       {{"", "(* nothing *)\n"}},
       {"2: The file has no statements. Expected FUNCTION_BLOCK."}},
      {"another language",
       {{"", "<world format=\"1\"/>\n"}},
       {"1: Found '<', which has no meaning in FCL. Remove it.",
        "1: Found '=', which has no meaning in FCL. Remove it.",
        "1: Found '\"', which has no meaning in FCL. Remove it.",
        "1: Found '>', which has no meaning in FCL. Remove it.",
        "1: Found 'world', expected FUNCTION_BLOCK at the beginning."}},
      {"no end of the function block",
       {{"END_FUNCTION_BLOCK\n", ""}},
       {"40: The file ends before END_FUNCTION_BLOCK. Is it complete?"}},
      {"a second function block",
       {{"END_FUNCTION_BLOCK\n",
         "END_FUNCTION_BLOCK\n\nFUNCTION_BLOCK more\nEND_FUNCTION_BLOCK\n"}},
       {"42: A second FUNCTION_BLOCK begins here, and a model is one of them. Name it: 'drive' or "
        "'more' (elsie fuzzy: --block NAME; in a world: the attribute block, left_block or "
        "right_block)."}},
      {"a block without end",
       {{"END_FUZZIFY\n\nFUZZIFY azimuth", "\nFUZZIFY azimuth"}},
       {"17: Found 'FUZZIFY', but the FUZZIFY that begins in line 12 is not closed. Write "
        "END_FUZZIFY before it."}},
      {"the end of a block that is not open",
       {{"RULEBLOCK rules", "END_VAR\nRULEBLOCK rules"}},
       {"32: Found 'END_VAR', but no such block is open here. Remove it."}},
      {"an unknown section",
       {{"RULEBLOCK rules", "OPTIONS\nEND_OPTIONS\nRULEBLOCK rules"}},
       {"32: Found 'OPTIONS', expected VAR_INPUT, VAR_OUTPUT, FUZZIFY, DEFUZZIFY, RULEBLOCK or "
        "END_FUNCTION_BLOCK."}},
      {"an unknown type",
       {{"azimuth : REAL", "azimuth : STRING"}},
       {"5: Found 'STRING', expected the type REAL: fuzzy models work on real numbers."}},
      {"a variable without type",
       {{"azimuth : REAL;", "azimuth;"}},
       {"5: Found ';', expected ':' between the name of a variable and its type."}},
      {"a keyword as a name",
       {{"azimuth : REAL", "not : REAL"}},
       {"5: Found the keyword NOT, expected the name of a variable."}},
      {"a variable declared twice",
       {{"azimuth : REAL;", "azimuth : REAL;\n  Range : REAL;"}},
       {"6: The variable 'Range' is declared a second time; the first is 'range' in line 4. Names "
        "are the same in any letter case: choose another one."}},
      {"an output with the name of an input",
       {{"speed : REAL", "azimuth : REAL"}},
       {"9: The variable 'azimuth' is declared a second time; the first is 'azimuth' in line 5. "
        "Names are the same in any letter case: choose another one.",
        "24: There is no output 'speed'. Declare it in VAR_OUTPUT or correct the name.",
        "36: There is no output 'speed'. Declare it in VAR_OUTPUT or correct the name.",
        "37: There is no output 'speed'. Declare it in VAR_OUTPUT or correct the name."}},
      {"an output without block",
       {{"speed : REAL;", "speed : REAL;\n  turn : REAL;"}},
       {"10: The variable 'turn' has no DEFUZZIFY block. Write one, or remove the variable."}},
      {"a block of an unknown variable",
       {{"FUZZIFY range", "FUZZIFY rage"}},
       {"4: The variable 'range' has no FUZZIFY block. Write one, or remove the variable.",
        "12: There is no input 'rage'. Did you mean 'range'? Declare it in VAR_INPUT or correct "
        "the name."}},
      {"a block of the wrong kind",
       {{"DEFUZZIFY speed\n", "FUZZIFY speed\n"}},
       {"28: Found 'METHOD', expected TERM, RANGE or END_FUZZIFY.",
        "29: Found 'DEFAULT', expected TERM, RANGE or END_FUZZIFY.",
        "30: Found 'END_DEFUZZIFY', but the FUZZIFY that begins in line 24 is not closed. Write "
        "END_FUZZIFY before it.",
        "30: Found 'END_DEFUZZIFY', but no such block is open here. Remove it."}},
      {"two blocks of one variable",
       {{"FUZZIFY azimuth", "FUZZIFY range\n  TERM none := 0;\nEND_FUZZIFY\nFUZZIFY azimuth"}},
       {"18: A second FUZZIFY block of 'range'; the first is in line 12. Put them together."}},
      {"an empty range",
       {{"RANGE := (0 .. 1)", "RANGE := (1 .. 1)"}},
       {"13: The RANGE (1 .. 1) of 'range' is empty: its lower end must be below its upper end."}},
      {"a range upside down",
       {{"RANGE := (-20 .. 30)", "RANGE := (30 .. -20)"}},
       {"25: The RANGE (30 .. -20) of 'speed' is empty: its lower end must be below its upper "
        "end."}},
      {"two ranges that differ",
       {{"  range : REAL;", "  range : REAL RANGE := (0 .. 2);"}},
       {"13: The RANGE (0 .. 1) of 'range' contradicts (0 .. 2) in line 4. Remove one of the "
        "two."}},
      {"a range twice",
       {{"RANGE := (0 .. 1);", "RANGE := (0 .. 1); RANGE := (0 .. 1);"}},
       {"13: RANGE is set a second time in this block. Remove one of the two."}},
      {"a range with a comma",
       {{"RANGE := (0 .. 1)", "RANGE := (0, 1)"}},
       {"13: Found ',', expected '..' between the two ends of RANGE."}},
      {"a variable without terms",
       {{"  TERM left := (-45, 0) (45, 1);\n  TERM right := (-45, 1) (45, 0);\n", ""}},
       {"18: The variable 'azimuth' has no terms. Write at least one TERM."}},
      {"a term twice",
       {{"TERM far :=", "TERM Near :="}},
       {"15: The term 'Near' of 'range' is defined a second time; the first is 'near' in line 14. "
        "Names are the same in any letter case: choose another one.",
        "36: The input 'range' has no term 'far'. Its terms are near."}},
      {"points that do not ascend",
       {{"(0.2, 0) (1, 1)", "(1, 1) (0.2, 0)"}},
       {"15: The points of the term 'far' do not ascend: (0.2, 0) comes after x = 1. Put them in "
        "the order of x."}},
      {"three points of one x",
       {{"(0.2, 0) (1, 1)", "(0.2, 0) (0.2, 1) (0.2, 0.5) (1, 1)"}},
       {"15: The points of the term 'far' do not ascend: x = 0.2 occurs too often. A step has two "
        "points of one x, with different degrees."}},
      {"a degree above 1",
       {{"(0.2, 0) (1, 1)", "(0.2, 0) (1, 1.5)"}},
       {"15: The point (1, 1.5) of the term 'far' has the degree 1.5. Degrees lie in 0 to 1."}},
      {"a negative degree",
       {{"(0.2, 0) (1, 1)", "(0.2, -0.1) (1, 1)"}},
       {"15: The point (0.2, -0.1) of the term 'far' has the degree -0.1. Degrees lie in 0 to 1."}},
      {"a single point",
       {{"(0.2, 0) (1, 1)", "(1, 0.5)"}},
       {"15: The term 'far' has one point only. Write a singleton as := 1, or give at least two "
        "points."}},
      {"a point without degree",
       {{"(0.2, 0) (1, 1)", "(0.2) (1, 1)"}},
       {"15: Found ')', expected ',' between x and degree of a point."}},
      {"an unknown shape",
       {{"(0.2, 0) (1, 1)", "Trianle 0 1 2"}},
       {"15: In the term 'far' of 'range': Found the shape 'Trianle', which is not known. Did you "
        "mean 'Triangle'? Known are Triangle, Trapezoid, Rectangle, Ramp, Discrete, Binary, "
        "Gaussian, GaussianProduct, Bell, Sigmoid, SigmoidDifference, SigmoidProduct, SShape, "
        "ZShape, PiShape, Cosine, Spike or Concave."}},
      {"too few parameters",
       {{"(0.2, 0) (1, 1)", "Triangle 0 1"}},
       {"15: In the term 'far' of 'range': Triangle takes 3 numbers (a b c) and perhaps a height, "
        "but here are 2."}},
      {"a triangle that does not ascend",
       {{"(0.2, 0) (1, 1)", "Triangle 1 0 2"}},
       {"15: In the term 'far' of 'range': The parameters of Triangle do not fit together: they "
        "must ascend."}},
      {"a curve without width",
       {{"(0.2, 0) (1, 1)", "Gaussian 0.5 0"}},
       {"15: In the term 'far' of 'range': The parameters of Gaussian do not fit together: the "
        "deviation must be above 0."}},
      {"a term without semicolon",
       {{"TERM far := (0.2, 0) (1, 1);\n", "TERM far := (0.2, 0) (1, 1) "}},
       {"15: Expected ';' at the end of the TERM statement, after ')', found 'END_FUZZIFY'."}},
      {"an output term outside of the range",
       {{"(10, 0) (20, 1) (30, 0)", "(40, 0) (50, 1) (60, 0)"}},
       {"27: The term 'fast' of 'speed' has no area within (-20 .. 30), so that nothing can be "
        "concluded from it. Correct the term or the RANGE."}},
      {"a singleton beside areas",
       {{"(10, 0) (20, 1) (30, 0)", "20"}},
       {"24: The output 'speed' has both singletons and terms with an area. Make all its terms of "
        "one kind."}},
      {"a singleton outside of the range",
       {{"TERM far := (0.2, 0) (1, 1)", "TERM far := 2"}},
       {"15: The singleton 'far' at 2 lies outside the RANGE (0 .. 1) of 'range'. Correct one of "
        "the two."}},
      {"an unknown method",
       {{"METHOD : COG", "METHOD : COGSS"}},
       {"28: Found 'COGSS' for METHOD, expected COG, COGS, COGF, COA, LM, RM, MM or MOM."}},
      {"singletons wanted",
       {{"METHOD : COG", "METHOD : COGS"}},
       {"28: COGS works on singletons, but the terms of 'speed' have an area. Use COG, or write "
        "the terms as := value. (COGS of sloping terms, Tsukamoto's method, is a fuzzylite "
        "extension, which is not supported.)"}},
      {"a method twice",
       {{"METHOD : COG;", "METHOD : COG; METHOD : COA;"}},
       {"28: METHOD is set a second time in this block. Remove one of the two."}},
      {"a default outside of the range",
       {{"DEFAULT := 0", "DEFAULT := 50"}},
       {"29: The DEFAULT 50 of 'speed' lies outside its RANGE (-20 .. 30). Correct one of the "
        "two."}},
      {"a default that is a word",
       {{"DEFAULT := 0", "DEFAULT := zero"}},
       {"29: Found 'zero', expected a number or NC after DEFAULT."}},
      {"no default where no rule fires",
       {{"  DEFAULT := 0;\n", ""}, {"(0.5, 0)", "(0.2, 0)"}},
       {"24: The output 'speed' has no DEFAULT, but no rule decides it at range = 0.2, azimuth = "
        "-90. Add DEFAULT := value to its DEFUZZIFY block, or a rule for this case."}},
      {"not a default where no rule fires",
       {{"DEFAULT := 0", "DEFAULT := nan"}, {"(0.5, 0)", "(0.2, 0)"}},
       {"24: The output 'speed' has no DEFAULT, but no rule decides it at range = 0.2, azimuth = "
        "-90. Add DEFAULT := value to its DEFUZZIFY block, or a rule for this case."}},
      {"an unknown operator for AND",
       {{"AND : MIN", "AND : MEAN"}},
       {"33: Found 'MEAN' for AND, expected MIN, PROD or BDIF."}},
      {"an unknown operator for OR",
       {{"AND : MIN", "OR : XOR"}},
       {"33: Found 'XOR' for OR, expected MAX, ASUM, PROBOR or BSUM."}},
      {"an unknown activation",
       {{"ACT : MIN", "ACT : MAX"}},
       {"34: Found 'MAX' for ACT, expected MIN or PROD."}},
      {"an unknown accumulation",
       {{"ACCU : MAX", "ACCU : DSUM"}},
       {"35: Found 'DSUM' for ACCU, expected MAX, ASUM, PROBOR, BSUM, NSUM or SUM. (This is a "
        "fuzzylite extension, which is not supported.)"}},
      {"accumulations that contradict each other",
       {{"METHOD : COG;", "METHOD : COG; ACCU : BSUM;"}},
       {"35: This ACCU contradicts that of line 28 for the output 'speed'. An output has one "
        "accumulation: make them the same."}},
      {"a rule block without rules",
       {{"  RULE 1 : IF range IS far OR azimuth IS left THEN speed IS fast;\n  RULE 2 : IF range "
         "IS near AND azimuth IS right THEN speed IS back;\n",
         ""},
        {"  DEFAULT := 0;\n", ""}},
       {"9: No rule decides the variable 'speed'. Write one, or remove the variable."}},
      {"an unknown variable in a condition",
       {{"range IS near", "rnage IS near"}},
       {"37: There is no input 'rnage'. Did you mean 'range'? Declare it in VAR_INPUT or correct "
        "the name."}},
      {"an unknown term in a condition",
       {{"range IS near", "range IS nearby"}},
       {"37: The input 'range' has no term 'nearby'. Did you mean 'near'? Its terms are near or "
        "far."}},
      {"an output in a condition",
       {{"range IS near", "speed IS back"}},
       {"37: 'speed' is an output. A condition asks for inputs; correct the name. (Conditions on "
        "outputs are an extension of fuzzylite and jFuzzyLogic, each in its own sense, which is "
        "not supported.)"}},
      {"an unknown variable in a conclusion",
       {{"speed IS back", "sped IS back"}},
       {"37: There is no output 'sped'. Did you mean 'speed'? Declare it in VAR_OUTPUT or correct "
        "the name."}},
      {"an unknown term in a conclusion",
       {{"speed IS back", "speed IS backward"}},
       {"37: The output 'speed' has no term 'backward'. Its terms are back or fast."}},
      {"an input in a conclusion",
       {{"speed IS back", "range IS near"}},
       {"37: 'range' is an input. A rule concludes on outputs; correct the name."}},
      {"a negated conclusion",
       {{"speed IS back", "speed IS NOT back"}},
       {"37: Found NOT in a conclusion, which says nothing definite. Name the term that is "
        "meant."}},
      {"a hedge",
       {{"range IS near", "range IS slightly near"}},
       {"37: Found the hedge 'slightly' before 'near'. FCL knows no hedges; very, extremely, "
        "somewhat and seldom are read as fuzzylite has them. Define a term of its own for what is "
        "meant."}},
      {"a rule without IF",
       {{": IF range IS near", ": range IS near"}},
       {"37: Found 'range', expected IF at the beginning of the rule."}},
      {"a rule without THEN",
       {{"azimuth IS right THEN", "azimuth IS right"}},
       {"37: Found 'speed', expected AND, OR or THEN after a condition."}},
      {"a condition without IS",
       {{"range IS near", "range near"}},
       {"37: Found 'near', expected IS after the variable 'range'."}},
      {"a condition without term",
       {{"range IS near AND", "range IS AND"}},
       {"37: Found the keyword AND, expected the name of a term after IS."}},
      {"a parenthesis that is not closed",
       {{"IF range IS near AND", "IF (range IS near AND"}},
       {"37: Found 'THEN', expected AND, OR or ')' after a condition."}},
      {"a weight above 1",
       {{"speed IS back;", "speed IS back WITH 2;"}},
       {"37: Rule 2 has the weight 2. Weights lie in 0 to 1."}},
      {"a weight that is a word",
       {{"speed IS back;", "speed IS back WITH half;"}},
       {"37: Found 'half', expected the weight of the rule after WITH, a number."}},
      {"a rule without number",
       {{"RULE 2 :", "RULE :"}},
       {"37: Found ':', expected the number or name of the rule."}},
      {"a rule without semicolon",
       {{"speed IS fast;", "speed IS fast DEFAULT"}},
       {"36: Expected ';' at the end of the RULE statement, after 'fast', found 'DEFAULT'."}},
  };
  return kAll;
}

std::string edited(const Mistake& mistake) {
  std::string text = kModel;
  for (const Edit& edit : mistake.edits) {
    if (edit.from.empty()) {
      text = edit.to;
      continue;
    }
    const std::size_t at = text.find(edit.from);
    REQUIRE(at != std::string::npos);
    text.replace(at, edit.from.size(), edit.to);
  }
  return text;
}

std::vector<std::string> messages_of(const std::string& text) {
  try {
    parse_fcl(text, "drive.fcl");
  } catch (const FclError& error) {
    std::vector<std::string> messages;
    for (const auto& problem : error.problems()) {
      CHECK(problem.file == "drive.fcl");
      messages.push_back(std::to_string(problem.line) + ": " + problem.message);
    }
    return messages;
  }
  return {"nothing wrong"};
}

}  // namespace

TEST_CASE("The model that is made wrong below is right") { CHECK_NOTHROW(parse_fcl(kModel)); }

TEST_CASE("Each mistake is reported with its line, what was found and what to do") {
  for (const Mistake& mistake : mistakes()) {
    INFO(mistake.what);
    CHECK(messages_of(edited(mistake)) == mistake.messages);
  }
}

TEST_CASE("All mistakes of a file are reported at once, in the order of its lines") {
  std::string text = kModel;
  const auto change = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  change("RANGE := (0 .. 1)", "RANGE := (1 .. 0)");
  change("METHOD : COG", "METHOD : CENTROID");
  change("range IS near", "range IS close");
  CHECK(messages_of(text) ==
        std::vector<std::string>{
            "13: The RANGE (1 .. 0) of 'range' is empty: its lower end must be below its upper "
            "end.",
            "28: Found 'CENTROID' for METHOD, expected COG, COGS, COGF, COA, LM, RM, MM or MOM.",
            "37: The input 'range' has no term 'close'. Its terms are near or far."});
}

TEST_CASE("An error's text has file and line in front of each sentence") {
  try {
    parse_fcl("FUNCTION_BLOCK\nVAR_INPUT\n", "folder/some.fcl");
    FAIL("loads");
  } catch (const FclError& error) {
    CHECK(std::string(error.what()) ==
          "folder/some.fcl:3: Found the end of the file, but the VAR_INPUT that begins in line 2 "
          "is not closed. Write END_VAR before it.\n"
          "folder/some.fcl:3: The file ends before END_FUNCTION_BLOCK. Is it complete?");
  }
}

TEST_CASE("A missing file and a directory are reported as such") {
  CHECK_THROWS_WITH(read_fcl("no/such/model.fcl"),
                    "no/such/model.fcl: There is no such file. Check the path.");
  CHECK_THROWS_WITH(read_fcl(elsie::test::source_path("")),
                    elsie::test::source_path("") +
                        ": This is a directory. Expected a file in Fuzzy Control Language.");
  CHECK_THROWS_WITH(read_fcl("/proc/self/mem"),
                    "/proc/self/mem: This cannot be read: Input/output error.");
}
