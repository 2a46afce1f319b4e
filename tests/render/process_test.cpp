#include "render/process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>

namespace frond {

TEST(Process, WordsReachAProgramAsTheyAre) {
  OutputCapture said;
  Command command;
  command.words = {"printf", "%s|", "a b", "$(x)", "'\"\n;", ""};
  command.out = said.descriptor();
  Result<int> code = run(command);
  ASSERT_TRUE(code);
  EXPECT_EQ(*code, 0);
  EXPECT_EQ(said.text(), "a b|$(x)|'\"\n;||");
}

TEST(Process, EndsWithItsCodeOrSignal) {
  Command command;
  command.words = {"sh", "-c", "exit 7"};
  EXPECT_EQ(*run(command), 7);
  command.words = {"sh", "-c", "kill -KILL $$"};
  EXPECT_EQ(*run(command), 128 + SIGKILL);
}

TEST(Process, OneThatIsNotThereIsAnError) {
  Command command;
  command.words = {"/no/such/program"};
  Result<int> code = run(command);
  ASSERT_FALSE(code);
  EXPECT_EQ(code.errors()[0].text(), "/no/such/program: No such file or directory");
  command.words = {"true"};
  command.folder = "/no/such/folder";
  EXPECT_FALSE(run(command));
}

TEST(Process, RunsWhereItIsToldWithWhatItIsGiven) {
  OutputCapture said;
  Command command;
  command.words = {"sh", "-c", "pwd; echo $FROND_OF_A_TEST; cat"};
  command.environment = {"FROND_OF_A_TEST=a b"};
  command.folder = "/";
  command.out = said.descriptor();
  EXPECT_EQ(*run(command), 0);
  EXPECT_EQ(said.text(), "/\na b\n");
}

TEST(Process, ConfinedItOpensWhatItIsGiven) {
  if (!can_confine()) GTEST_SKIP();
  OutputCapture said;
  Command command;
  command.words = {"sh", "-c", "cat /etc/passwd || echo refused; ls / >&2 || echo refused"};
  command.out = command.err = said.descriptor();
  command.confinement = Confinement{};
  EXPECT_EQ(*run(command), 0);
  EXPECT_NE(said.text().find("refused\nls: "), std::string::npos) << said.text();
  command.confinement = Confinement{{"/etc/passwd"}, {}};
  command.words = {"cat", "/etc/passwd"};
  EXPECT_EQ(*run(command), 0);
  command.confinement = Confinement{{"/no/such/file"}, {}};
  EXPECT_FALSE(run(command));
}

TEST(Process, ProgramsAreFoundAsByAShell) {
  EXPECT_TRUE(find_program("sh"));
  EXPECT_FALSE(find_program("no-such-program-anywhere"));
  EXPECT_FALSE(find_program("/etc/passwd"));
  EXPECT_FALSE(find_program("/"));
}

}  // namespace frond
