#include <fmt/format.h>
#include <httplib.h>
#include <pthread.h>
#include <signal.h>
#include <sys/random.h>
#include <sys/signalfd.h>

#include <array>

#include "core/files.h"
#include "core/parallel.h"
#include "core/read_as.h"
#include "preset/json.h"
#include "render/process.h"
#include "studio/answers.h"
#include "studio/connections.h"
#include "studio/exports.h"
#include "studio/films.h"
#include "studio/grammar_files.h"
#include "studio/page.h"
#include "studio/renders.h"
#include "studio/scenes.h"
#include "studio/send.h"
#include "studio/studio.h"

namespace frond {

namespace {

using httplib::Request;
using httplib::Response;

constexpr const char* kHost = "127.0.0.1";
constexpr std::size_t kMostMesh = std::size_t{65} << 20, kMostText = std::size_t{8} << 20;  // bytes
constexpr const char* kPolicy =
    "default-src 'self'; img-src 'self' blob: data:; style-src 'self' 'unsafe-inline'; frame-ancestors "
    "'none'; base-uri 'none'; form-action 'none'";

/// 32 hexadecimal digits that nobody can guess; empty where the system gives no random numbers.
std::string token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return {};
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

/// Whether two texts are the same; it takes as long whether the first or the last character differs.
bool same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  int differs = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differs |= a[i] ^ b[i];
  return differs == 0;
}

/// The number of a question among those of its tab; 0 where it has none.
std::uint64_t sequence_of(const Request& request) {
  return read_as<std::uint64_t>(request.get_param_value("seq")).value_or(0);
}

Answer ok(Json json) { return {200, std::move(json)}; }

/// A picture. Where there is none, why; with the status 204 nothing, as a 404 would stand on the browser's
/// console as a fault.
Answer picture(const Result<std::string>& bytes, const char* type = "image/png", int none = 404) {
  if (!bytes) return refused(none, bytes.errors().front().text());
  return {200, {}, *bytes, type};
}

/// What was begun, or why it was not.
Answer begun(const char* name, const Result<std::string>& made) {
  if (!made) return {422, {{"errors", errors_json(made.errors())}}};
  return ok({{name, *made}});
}

/// What there is of that name, or that there is none.
template <class T>
Answer found(const char* kind, const T& there) {
  if (!there) return refused(404, fmt::format("there is no such {}", kind));
  if constexpr (std::is_same_v<T, bool>)
    return ok({{"ok", true}});
  else
    return ok(*there);
}

class Server {
 public:
  explicit Server(const StudioOptions& options)
      : options_(options),
        documents_(options),
        scenes_(documents_, options.memory, options.bake),
        renders_(documents_, scenes_, options.home),
        films_(documents_) {}

  Errors serve() {
    if (page_files().empty())
      return {Error{"",
                    "the page of the studio is not built; `scripts/setup.sh --studio` does it, then "
                    "`scripts/build.sh` puts it into the program"}};
    if (token_.empty() || started_.empty()) return {Error{"", "the system gives no random numbers"}};
    server_.set_payload_max_length(kMostMesh);
    server_.set_keep_alive_max_count(10'000);
    server_.set_keep_alive_timeout(server_.limits.idle.count());
    server_.caller = [this](std::string_view head) { return caller(head); };
    server_.leaves = [this] { scenes_.end(), renders_.end(); };
    server_.refuses = [this](const Request& request) { return refusal(request).has_value(); };
    // Another program's port is not to be shared.
    server_.set_socket_options([](socket_t socket) {
      int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server_.set_default_headers({{"Content-Security-Policy", kPolicy},
                                 {"X-Content-Type-Options", "nosniff"},
                                 {"Referrer-Policy", "no-referrer"},
                                 {"Cache-Control", "no-store"}});
    add_routes();
    port_ = options_.port ? options_.port : kUsualPort;
    if (!server_.bind_to_port(kHost, port_)) port_ = options_.port ? -1 : server_.bind_to_any_port(kHost);
    if (port_ <= 0)
      return {Error{"--port", options_.port ? fmt::format("{} is taken, or may not be used", options_.port)
                                            : "no port is free"}};
    return listen();
  }

 private:
  /// Until a signal comes.
  Errors listen() {
    sigset_t ends;
    sigemptyset(&ends);
    for (int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ends, signal);
    pthread_sigmask(SIG_BLOCK, &ends, nullptr);
    signal(SIGPIPE, SIG_IGN);
    int asked = signalfd(-1, &ends, SFD_CLOEXEC);
    if (options_.ready) options_.ready(fmt::format("http://{}:{}/#token={}", kHost, port_, token_));
    bool served = asked >= 0 && server_.serve(asked);
    return served ? Errors{} : Errors{Error{"", "the server could not listen"}};
  }

  /// Who has the token, by the head of a request alone: all else is for refusal() to tell.
  Caller caller(std::string_view head) const {
    auto [method, target] = asked_for(head);
    std::string_view given = header_of(head, "X-Frond-Token");
    constexpr std::string_view kToken = "token=";
    std::size_t at = target.find(kToken, std::min(target.find('?'), target.size()));
    if (given.empty() && method == "GET" && at != target.npos)
      given = target.substr(at + kToken.size(), token_.size());
    if (same(given, token_)) return Caller::known;
    return target.starts_with("/api/") ? Caller::refused : Caller::unknown;
  }

  /// Why a request is not answered, of which only the head was read. It has to come from our own page: no
  /// other site can name us its host, nor send our token. What follows has to say how long it is.
  std::optional<Answer> refusal(const Request& request) const {
    std::string host = request.get_header_value("Host"), origin = request.get_header_value("Origin");
    std::string own = fmt::format("{}:{}", kHost, port_), local = fmt::format("localhost:{}", port_);
    if ((host != own && host != local) || (!origin.empty() && origin != "http://" + host))
      return refused(421, "a request from another site");
    bool api = request.path.starts_with("/api/"), gets = request.method == "GET" || request.method == "HEAD";
    if (!gets && !(api && (request.method == "POST" || request.method == "DELETE")))
      return refused(405, "that is not done here");
    bool told = request.get_header_value_count("Content-Length") == 1;
    if (request.has_header("Transfer-Encoding") || (request.method == "POST" && !told))
      return refused(411, "the length of what is sent has to be told beforehand");
    if (request.has_header("Content-Encoding")) return refused(415, "what is sent must not be compressed");
    std::size_t most = gets                                                            ? 0
                       : request.path == "/api/mesh" || request.path == "/api/painted" ? kMostMesh
                                                                                       : kMostText;
    if (told && request.get_header_value<std::uint64_t>("Content-Length") > most)
      return refused(413, "what is sent is too long");
    if (!api) return std::nullopt;
    std::string given = request.get_header_value("X-Frond-Token");
    // An img element sends no headers of ours.
    if (given.empty() && request.method == "GET") given = request.get_param_value("token");
    if (same(given, token_)) return std::nullopt;
    return refused(403, kNoToken);
  }

  /// Handlers that give an answer.
  using Give = std::function<Answer(const Request&)>;
  static httplib::Server::Handler handler(Give give) {
    return [give = std::move(give)](const Request& request, Response& response) {
      send(response, give(request));
    };
  }
  void get(const std::string& path, Give give) { server_.Get(path, handler(std::move(give))); }
  void take(const std::string& path, Give give) { server_.Post(path, handler(std::move(give))); }
  void remove(const std::string& path, Give give) { server_.Delete(path, handler(std::move(give))); }

  /// A handler for JSON that holds `doc`, a preset.
  using Ask = std::function<Answer(const Request&, const Json&, Doc)>;
  void post(const std::string& path, Ask ask) {
    take(path, [this, ask](const Request& request) {
      Json question = Json::parse(request.body, nullptr, false);
      if (!question.is_object()) return refused(400, "no JSON object");
      Doc doc;
      if (question.contains("doc")) {
        const Json& given = question["doc"];
        if (!given.is_object() || !given.value("text", Json()).is_string() ||
            !given.value("file", Json()).is_string())
          return refused(400, "doc wants text and file");
        auto path_of = documents_.readable(given["file"].get<std::string>());
        if (!path_of) return refused(403, "the file is in no folder that the studio may read");
        doc = {given["text"].get<std::string>(), *path_of};
      }
      return ask(request, question, std::move(doc));
    });
  }

  void add_routes() {
    server_.set_pre_routing_handler([this](const Request& request, Response& response) {
      std::optional<Answer> no = refusal(request);
      if (!no) return httplib::Server::HandlerResponse::Unhandled;
      send(response, std::move(*no));
      return httplib::Server::HandlerResponse::Handled;
    });
    server_.set_exception_handler([](const Request&, Response& response, const std::exception_ptr& error) {
      send(response, fault_answer(error));
    });
    add_page();
    add_documents();
    add_scenes();
    add_renders();
    add_films();
  }

  void add_page() {
    for (const PageFile& file : page_files()) {
      auto give = [&file](const Request&, Response& response) {
        response.set_content(file.bytes.data(), file.bytes.size(), std::string(file.type));
      };
      std::string path;
      for (char c : file.path)
        path += std::isalnum(static_cast<unsigned char>(c)) || c == '/' ? std::string(1, c)
                                                                        : std::string{'\\', c};
      server_.Get(path, give);
      if (file.path == "/index.html") server_.Get("/", give);
    }
  }

  void add_documents() {
    get("/api/ping", [this](auto&) {
      return ok({{"ok", true}, {"started", started_}, {"kept", scenes_.kept()}, {"room", options_.memory}});
    });
    server_.Get("/api/start", [this](const Request&, Response& response) {
      // The schema, which is most of it, is written once.
      static const std::string schema = ",\"schema\":" + serialize(preset_schema()) + "}";
      send(response,
           ok({{"started", started_},
               {"machine", {{"cores", thread_count()}, {"farm", find_program("sbatch").has_value()}}},
               {"symbols", symbols_json()},
               {"preset", documents_.opened()},
               {"presets", documents_.shipped()},
               {"strips", documents_.strips()}}));
      response.body.replace(response.body.size() - 1, 1, schema);
    });
    get("/api/preset", [this](auto& request) {
      Result<Json> read = documents_.read(request.get_param_value("file"));
      return read ? ok(*read) : refused(403, read.errors().front().text());
    });
    get("/api/disk", [this](auto& request) {
      return ok({{"disk", documents_.disk(request.get_param_value("file"))}});
    });
    get("/api/files", [this](auto&) { return ok(documents_.own()); });
    get("/api/look", [this](auto& request) {
      return picture(scenes_.look(request.get_param_value("file")), "image/png", 204);
    });
    get(R"(/api/(gallery|strip|docs)/(.+))", [this](auto& request) {
      const char* type = request.matches[1] == "docs" ? "text/plain; charset=utf-8" : "image/jpeg";
      return picture(documents_.leaf(request.matches[1].str(), request.matches[2]), type);
    });
    post("/api/save", [this](auto&, const Json& question, const Doc& doc) -> Answer {
      std::string file = question.at("file").get<std::string>();
      std::string disk = question.contains("disk") && question["disk"].is_string()
                             ? question["disk"].get<std::string>()
                             : "";
      if (doc.file.empty()) return refused(400, "doc is missing");
      if (!question.value("force", false))
        if (Result<Preset> preset = documents_.preset(doc); !preset)
          return {422, {{"errors", errors_json(preset.errors())}}};
      return documents_.save(file, doc, disk, question.value("overwrite", false));
    });
    get("/api/painted", [this](auto& request) {
      documents_.restore(request.get_param_value("file"));
      auto file = documents_.readable(request.get_param_value("file"));
      if (!file || file->extension() != ".png") return refused(403, "no such picture may be read");
      return picture(read_file(*file));
    });
    take("/api/painted", [this](auto& request) {
      if (!request.body.starts_with("\x89PNG")) return refused(400, "the file is no picture");
      return documents_.add_file(request.get_param_value("name"), ".png", request.body,
                                 request.get_param_value("of"));
    });
    take("/api/mesh", [this](auto& request) {
      const httplib::MultipartFormData mesh = request.get_file_value("mesh");
      std::map<std::string, std::string> beside;
      for (auto [at, end] = request.files.equal_range("beside"); at != end; ++at)
        beside.emplace(at->second.filename, at->second.content);
      return documents_.add_mesh(mesh.filename, mesh.content, beside, request.get_param_value("of"));
    });
  }

  void add_scenes() {
    post("/api/scene", [this](auto& request, auto& question, const Doc& doc) {
      return scenes_.view(doc, question, request.get_param_value("session"), sequence_of(request));
    });
    get("/api/scene",
        [this](auto& request) { return ok(scenes_.progress(request.get_param_value("session"))); });
    remove("/api/scene", [this](auto& request) {
      scenes_.leave(request.get_param_value("session"), sequence_of(request));
      return ok({{"ok", true}});
    });
    post("/api/pick", [this](auto&, auto& question, const Doc& doc) { return scenes_.pick(doc, question); });
    post("/api/derive",
         [this](auto&, auto& question, const Doc& doc) { return scenes_.derive(doc, question); });
    post("/api/grammar",
         [this](auto&, auto& question, const Doc&) { return grammar_files(documents_, question); });
    post("/api/grammar/change",
         [this](auto&, auto& question, const Doc&) { return changed_grammar(documents_, question); });
    post("/api/ball", [this](auto&, auto& question, const Doc& doc) {
      return picture(scenes_.ball(doc, index_in(question, "entry", 0)), "image/png", 204);
    });
    post("/api/trace",
         [this](auto&, auto& question, const Doc& doc) { return scenes_.trace(doc, question); });
    get(R"(/api/picture/([A-Za-z0-9_.-]+))",
        [this](auto& request) { return picture(scenes_.picture(request.matches[1])); });
  }

  void add_renders() {
    post("/api/render", [this](auto&, const Json& question, Doc doc) {
      return begun("id", renders_.begin(std::move(doc), time_in(question), size_in(question),
                                        question.value("quality", "draft")));
    });
    post("/api/export", [this](auto&, auto& question, const Doc& doc) {
      auto path = export_doc(documents_, options_.home, doc, export_order(question));
      return begun("file", path ? Result(path->string()) : path.errors());
    });
    post("/api/export/size", [this](auto&, auto& question, const Doc& doc) {
      return export_size(documents_, scenes_, doc, export_order(question));
    });
    get("/api/renders", [this](auto&) { return ok(renders_.list()); });
    get(R"(/api/render/(\d+))",
        [this](auto& request) { return found("render", renders_.state(request.matches[1])); });
    get(R"(/api/render/(\d+)/doc)", [this](auto& request) {
      std::optional<Doc> doc = renders_.doc(request.matches[1]);
      std::optional<Json> json;
      if (doc) json = {{"text", doc->text}, {"file", doc->file.string()}};
      return found("render", json);
    });
    get(R"(/api/render/(\d+)/picture)",
        [this](auto& request) { return picture(renders_.picture(request.matches[1])); });
    remove(R"(/api/render/(\d+))",
           [this](auto& request) { return found("render", renders_.cancel(request.matches[1])); });
  }

  void add_films() {
    post("/api/film", [this](auto&, const Json& question, const Doc& doc) {
      FilmOrder order;
      order.size = size_in(question);
      order.quality = question.value("quality", order.quality), order.frames = question.value("range", "");
      order.rough = question.value("rough", order.rough), order.farm = question.value("farm", order.farm);
      return begun("id", films_.begin(doc, order));
    });
    post("/api/moment", [this](auto&, auto& question, const Doc& doc) {
      return picture(scenes_.moment(doc, time_in(question)), "image/png", 204);
    });
    get("/api/films", [this](auto&) { return ok(films_.list()); });
    get(R"(/api/film/([\w-]+))",
        [this](auto& request) { return found("film", films_.state(request.matches[1])); });
    server_.Get(R"(/api/film/([\w-]+)/([\w.]+))", [this](const Request& request, Response& response) {
      std::optional<std::filesystem::path> file = films_.file(request.matches[1], request.matches[2]);
      if (file) return send_file(response, *file);
      // What shows what is traced comes and goes.
      send(response, request.matches[2] == "watch.png" ? Answer{204} : found("film", false));
    });
    take(R"(/api/film/([\w-]+)/pause)",
         [this](auto& request) { return found("film", films_.pause(request.matches[1])); });
    take(R"(/api/film/([\w-]+)/resume)",
         [this](auto& request) { return found("film", films_.resume(request.matches[1])); });
    remove(R"(/api/film/([\w-]+))",
           [this](auto& request) { return found("film", films_.remove(request.matches[1])); });
  }

  StudioOptions options_;
  std::string token_ = token(), started_ = token();
  int port_ = -1;
  Documents documents_;
  Scenes scenes_;
  Renders renders_;
  Films films_;
  Connections server_;
};

}  // namespace

Errors serve_studio(const StudioOptions& options) { return Server(options).serve(); }

}  // namespace frond
