#include "commands/versus/versus_scene.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "commands/base/content_hash.h"
#include "commands/base/difference_file.h"
#include "commands/base/run_place.h"
#include "commands/base/values.h"
#include "commands/base/write_bytes.h"
#include "commands/report/result_json.h"
#include "commands/versus/program_told.h"
#include "commands/versus/scene_files.h"
#include "commands/versus/versus_json.h"
#include "commands/versus/versus_judge.h"
#include "grading/judge.h"
#include "grading/run_folder.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_run_bytes = 1u << 26;  ///< of what a run of ours writes as JSON
constexpr double difference_scale = 8.0;
constexpr const char* result_name = "result.json";

std::string difference_name(Maker maker) { return "difference_" + picture_name(maker); }

/// What reading a scene tells before any ray.
struct Reading {
    std::vector<MissingFeature> missing;  ///< each once, where it is first
    bool draws_edges = false;             ///< lines that POV-Ray has not
};

/// What a run of ours has written as JSON; empty if it is not there or not whole.
template <class T, class Read>
std::optional<T> read_written(const std::string& path, const Read& read) {
    std::optional<std::string> text = read_file_text(path, most_run_bytes);
    if (!text) return std::nullopt;
    Sources sources;
    sources.add({path, std::move(*text)});
    try {
        const nlohmann::json content = parse_json(sources);
        return read(JsonValue(sources, content));
    } catch (const SceneError&) {
        return std::nullopt;
    }
}

class SceneRun {
public:
    SceneRun(const VersusSettings& settings, const VersusScene& scene, const EntryStore& known, int slot)
        : settings_(settings), scene_(scene), known_(known), slot_(slot) {
        result_.name = scene.name, result_.path = scene.path;
    }

    VersusResult run() {
        const Reading reading = read();
        result_.missing = reading.missing, draws_edges_ = reading.draws_edges;
        const std::string key = content_key();
        if (settings_.fresh || key.empty() || !take_known(key)) run_povray(key);
        for (const Maker maker : {Maker::same, Maker::general}) run_ours(maker, reading);
        compare();
        result_.cause = cause_of(result_, settings_.agreement);
        return std::move(result_);
    }

private:
    std::string place_of(const std::string& name) const { return (fs::path(pictures_of(settings_, scene_)) / name).string(); }

    Ending run_in(const std::string& folder, const std::vector<std::string>& command) const {
        return run_program_for(settings_, command, {folder, fs::path(scene_.path).parent_path().string()}, slot_);
    }

    /// By `raytrace requires`, contained as the others: a scene may never end.
    Reading read() const {
        std::vector<std::string> command = {settings_.program, "requires", scene_.path, "--json"};
        command.insert(command.end(), settings_.words.begin(), settings_.words.end());
        const RunPlace place;
        const Ending ending = run_in(place.folder(), command);
        Reading reading;
        if (ending.kind != Ending::Kind::exited || ending.status != 0) return reading;  // what is wrong, a render tells as well
        Sources sources;
        sources.add({"raytrace requires", ending.output});
        const nlohmann::json content = parse_json(sources);
        const JsonValue needs = JsonValue(sources, content)["scenes"].item(0), missing = needs["not_modelled"],
                        features = needs["features"];
        for (std::size_t i = 0; i < features.size(); ++i)
            reading.draws_edges = reading.draws_edges || features.item(i).word() == "edge lines";
        std::set<std::string> names;
        for (std::size_t i = 0; i < missing.size(); ++i) {
            const JsonValue m = missing.item(i);
            if (!names.insert(m["name"].word()).second) continue;
            reading.missing.push_back({m["name"].word(), m["file"].word(), m["line"].count(), m["column"].count()});
        }
        return reading;
    }

    /// Everything that POV-Ray's picture depends on; threads are not among it. Empty if that cannot be known.
    std::string content_key() const {
        std::vector<std::string> folders = settings_.job.parse.library_paths, words;
        folders.insert(folders.end(), settings_.installed.begin(), settings_.installed.end());
        for (const auto& [name, value] : settings_.job.parse.declares) words.push_back(value);
        const SceneFiles files = files_of_scene(scene_.path, folders, settings_.installed, words);
        if (!files.complete) return {};
        std::string rule = fmt::format("{}\n{}\n{}\n", settings_.version, settings_.povray_hash, files.fingerprint);
        for (const std::string& word : povray_picture_words(settings_.job)) rule += word + "\n";
        return hash_of(rule);
    }

    bool take_known(const std::string& key) {
        std::optional<VersusRun> known = read_written<VersusRun>(
            known_.path(key, "run.json"), [](const JsonValue& value) { return run_of_json(value["run"], value["times"]); });
        if (!known) return false;
        const std::optional<std::string> picture = read_file_text(known_.path(key, "picture.png"), settings_.limits.file_bytes);
        if (!picture) return false;
        write_bytes(place_of(picture_name(Maker::povray)), *picture);
        if (!picture_problem(Maker::povray).empty()) return false;
        result_.run(Maker::povray) = std::move(*known);
        note_command(Maker::povray);  // for where its picture lies now
        return true;
    }

    std::vector<std::string> command_for(Maker maker, const std::string& picture) const {
        if (maker == Maker::povray) return povray_command_to_copy(settings_, scene_.path, picture);
        std::vector<std::string> command = our_command(settings_, scene_.path, maker, picture);
        if (maker == Maker::same && draws_edges_) command.emplace_back("--edges=off");
        return command;
    }

    void note_command(Maker maker) { result_.run(maker).command = command_as_text(command_for(maker, place_of(picture_name(maker)))); }

    /// What is wrong with a picture that was written, or nothing.
    std::string picture_problem(Maker maker) const {
        const RenderJob& job = settings_.job;
        try {
            const StoredImage image = read_image(place_of(picture_name(maker)));
            if (image.width == job.width && image.height == job.height) return {};
            return fmt::format("the picture has {} x {} pixels instead of {} x {}", image.width, image.height, job.width, job.height);
        } catch (const OptionError& error) {
            return error.what();
        }
    }

    /// Runs one of the programs and keeps its picture. Messages have to be freed from the links in the names.
    std::pair<Ending, PovrayNames> run_maker(Maker maker) {
        VersusRun& run = result_.run(maker);
        const RunPlace place;
        const std::string to = (fs::path(place.folder()) / picture_name(maker)).string();
        PovrayNames names(place.folder());
        const std::vector<std::string> command =
            maker == Maker::povray ? povray_command(settings_, scene_.path, to, names) : command_for(maker, to);
        names.make_links();
        const Ending ending = run_in(place.folder(), command);
        note_command(maker);
        run.alone = settings_.alone, run.threads = settings_.threads;
        run.wall_seconds = ending.wall_seconds, run.cpu_seconds = ending.cpu_seconds, run.peak_memory_bytes = ending.peak_memory_bytes;
        run.state = VersusRun::State::failed;
        run.message = ending_reason(ending, settings_.limits);
        if (ending.kind != Ending::Kind::exited) return {ending, names};
        const TakenFile picture = take_file(place.folder(), picture_name(maker), settings_.limits.file_bytes);
        if (ending.status == 0 && picture.bytes) {
            write_bytes(place_of(picture_name(maker)), *picture.bytes);
            run.message = picture_problem(maker);
            if (run.message.empty()) run.state = VersusRun::State::done;
        } else if (ending.status == 0) {
            run.message = picture.problem;
        }
        return {ending, names};
    }

    void run_povray(const std::string& key) {
        const auto [ending, names] = run_maker(Maker::povray);
        VersusRun& run = result_.run(Maker::povray);
        read_povray_statistics(ending.output, run);
        const std::string message = names.without_links(povray_message(povray_lines(ending.output)));
        if (ending.kind == Ending::Kind::exited && ending.status != 0) {
            if (message.find("Error: ") != message.npos)
                run.state = VersusRun::State::refused, run.message = message;
            else if (!message.empty())
                run.message += ": " + message;
        }
        // A refusal is not kept: it is quick, and names files that may lie elsewhere next time.
        if (run.state != VersusRun::State::done || key.empty()) return;
        known_.put(key, {{"run.json", json_text({{"run", run_json(run)}, {"times", run_times_json(run)}}, 1)},
                         {"picture.png", read_file_text(place_of(picture_name(Maker::povray)), settings_.limits.file_bytes).value()}});
    }

    void run_ours(Maker maker, const Reading& reading) {
        VersusRun& run = result_.run(maker);
        if (!reading.missing.empty()) {
            const MissingFeature& first = reading.missing.front();
            note_command(maker);
            run.state = VersusRun::State::refused;
            run.message = fmt::format("{}:{}:{}: {} is not modelled", first.file, first.line, first.column, first.name);
            return;
        }
        const Ending ending = run_maker(maker).first;
        read_our_statistics(ending.output, run);
        // Statuses 1 and 4 are about the scene: a mistake in it, or a limit of ours.
        if (ending.kind != Ending::Kind::exited || ending.status == 0) return;
        const std::string message = our_message(ending.output);
        if (ending.status == 1 || ending.status == 4)
            run.state = VersusRun::State::refused, run.message = message;
        else if (!message.empty())
            run.message += ": " + message;
    }

    void compare() {
        if (result_.run(Maker::povray).state != VersusRun::State::done) return;
        const std::string theirs = picture_name(Maker::povray);
        const StoredImage povray = read_image(place_of(theirs));
        for (const Maker maker : {Maker::same, Maker::general}) {
            if (result_.run(maker).state != VersusRun::State::done) continue;
            const StoredImage ours = read_image(place_of(picture_name(maker)));
            result_.like(maker) = likeness_of(povray, ours, settings_.agreement);
            write_difference_picture({theirs, povray}, {picture_name(maker), ours}, difference_scale, place_of(difference_name(maker)),
                                     ImageFormat::png);
        }
    }

    const VersusSettings& settings_;
    const VersusScene& scene_;
    const EntryStore& known_;
    int slot_;
    bool draws_edges_ = false;
    VersusResult result_;
};

}  // namespace

std::string pictures_of(const VersusSettings& settings, const VersusScene& scene) {
    return (fs::path(settings.folder) / "pictures" / scene.name).string();
}

void run_scene(const VersusSettings& settings, const VersusScene& scene, const EntryStore& known, int slot) {
    const VersusResult result = SceneRun(settings, scene, known, slot).run();
    write_bytes((fs::path(pictures_of(settings, scene)) / result_name).string(),
                json_text({{"result", versus_json(result)}, {"times", versus_times_json(result)}}, 1));
}

std::optional<VersusResult> result_of_scene(const VersusSettings& settings, const VersusScene& scene) {
    const std::string path = (fs::path(pictures_of(settings, scene)) / result_name).string();
    return read_written<VersusResult>(path, [](const JsonValue& value) { return versus_of_json(value["result"], value["times"]); });
}

void remove_result_of(const VersusSettings& settings, const VersusScene& scene) {
    std::vector<std::string> names = {result_name};
    for (const auto& [name, maker] : maker_names) names.insert(names.end(), {picture_name(maker), difference_name(maker)});
    std::error_code none;
    for (const std::string& name : names) fs::remove(fs::path(pictures_of(settings, scene)) / name, none);
}

VersusResult result_without_run(const VersusScene& scene, VersusRun::State state, const std::string& message) {
    VersusResult result;
    result.name = scene.name, result.path = scene.path;
    result.cause = state == VersusRun::State::failed ? VersusCause::failed : VersusCause::not_run;
    for (VersusRun& run : result.runs) run.state = state, run.message = message;
    return result;
}

}  // namespace rt
