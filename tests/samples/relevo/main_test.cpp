// The command line as such: help, version, exit status, words it does not know.
#include <gtest/gtest.h>

#include "tests/samples/relevo/program.hpp"

namespace relevo::command {
namespace {

using io::TemporaryFolder;

void expect_refused(const std::string& arguments, const std::string& error) {
    const TemporaryFolder folder;
    const Outcome outcome = run(folder, arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(outcome.err, error + "\n");
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(folder.names().empty());
}

TEST(Relevo, TellsItsVersion) {
    const Outcome outcome = run(TemporaryFolder(), "--version");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "relevo " RELEVO_VERSION "\n");
    EXPECT_EQ(outcome.err, "");
}

TEST(Relevo, EveryCommandHelpsWithAnExample) {
    for (const std::string command : {"", "render", "steps", "compare", "list"}) {
        const Outcome outcome = run(TemporaryFolder(), command + " --help");
        EXPECT_EQ(outcome.status, 0) << command;
        EXPECT_NE(outcome.out.find("Example"), std::string::npos) << command;
        EXPECT_NE(outcome.out.find("relevo " + command), std::string::npos) << command;
        EXPECT_EQ(outcome.err, "") << command;
    }
}

TEST(Relevo, SaysWhatItDoesNotKnow) {
    expect_refused(
        "",
        "relevo: a command is missing, accepted: render, steps, compare, list (relevo --help tells more)");
    expect_refused("rendr x.toml",
                   "relevo: unknown command 'rendr', did you mean 'render'? (relevo --help tells more)");
    expect_refused("zzz", "relevo: unknown command 'zzz' (relevo --help tells more)");
    expect_refused("--versio",
                   "relevo: unknown option '--versio', did you mean '--version'? (relevo --help tells more)");
    expect_refused("render", "relevo render: SCENE is required (relevo render --help tells more)");
    expect_refused("render a.toml --sise=3x3",
                   "relevo render: unknown option '--sise=3x3', did you mean '--size'? (relevo render --help "
                   "tells more)");
    expect_refused("render a.toml b.toml",
                   "relevo render: 'b.toml' is one argument too many (relevo render --help tells more)");
    expect_refused(
        "list knobz",
        "relevo list knobz: accepted: stages, knobs, algorithms, events, formats, did you mean 'knobs'?");
    expect_refused("list stages --accuracy",
                   "relevo list --accuracy: accepted: relevo list knobs --accuracy");
}

TEST(Relevo, AFullStandardOutputIsNoSuccess) {
    const Outcome outcome = shell(TemporaryFolder(), "relevo list >/dev/full");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "standard output: cannot be written\n");
}

// these sanitizers need terabytes of addresses, so that no limit can be set
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(Relevo, TooLittleMemoryIsSaid) {
    const TemporaryFolder folder;
    folder.write("s.toml", "[[object]]\nmesh = \"cube\"\n");
    const Outcome outcome = shell(folder, "ulimit -v 200000; relevo render s.toml --size 8192x8192");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "relevo: there is not enough memory for this\n");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"s.toml"});
}
#endif

TEST(Relevo, AReaderThatGoesAwayEndsItQuietly) {
    const Outcome outcome = shell(TemporaryFolder(), "relevo list knobs --accuracy | head -1; echo");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
}

TEST(List, HasASentenceForEverything) {
    const TemporaryFolder folder;
    const std::string stages = run(folder, "list stages").out;
    for (const char* stage :
         {"object", "world", "eye", "clip", "clipped", "ndc", "window", "culled", "coverage", "depth",
          "visibility", "attributes", "flat", "gouraud", "phong", "texture", "final"})
        EXPECT_NE(("\n" + stages).find("\n" + std::string(stage) + " "), std::string::npos) << stage;
    const std::string all = run(folder, "list").out;
    for (const char* list : {"stages", "knobs", "algorithms", "events", "formats"}) {
        const Outcome one = run(folder, std::string("list ") + list);
        EXPECT_EQ(one.status, 0);
        EXPECT_NE(all.find(one.out), std::string::npos) << list;
    }
    EXPECT_NE(run(folder, "list knobs --accuracy").out.find("instructions"), std::string::npos);
}

}  // namespace
}  // namespace relevo::command
