#include <fmt/format.h>
#include <httplib.h>
#include <pthread.h>
#include <signal.h>
#include <sys/signalfd.h>

#include "core/files.h"
#include "core/machine.h"
#include "core/parallel.h"
#include "core/read_as.h"
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
#include "studio/token.h"

namespace frond {

namespace {

using httplib::Request;
using httplib::Response;

constexpr const char* kHost = "127.0.0.1";
constexpr std::size_t kMostMesh = std::size_t{65} << 20, kMostText = std::size_t{8} << 20;  // bytes
constexpr const char* kPolicy =
    "default-src 'self'; img-src 'self' blob: data:; style-src 'self' 'unsafe-inline'; frame-ancestors "
    "'none'; "
    "base-uri 'none'; form-action 'none'";

/// The number of a question among those of its tab; 0 where it has none.
std::uint64_t sequence_of(const Request& request) {
  return read_as<std::uint64_t>(request.get_param_value("seq")).value_or(0);
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
  std::optional<Refusal> refusal(const Request& request) const {
    auto no = [](int status, const char* why) { return Refusal{status, {{"error", why}}}; };
    std::string host = request.get_header_value("Host"), origin = request.get_header_value("Origin");
    std::string own = fmt::format("{}:{}", kHost, port_), local = fmt::format("localhost:{}", port_);
    if ((host != own && host != local) || (!origin.empty() && origin != "http://" + host))
      return no(421, "a request from another site");
    bool api = request.path.starts_with("/api/"), gets = request.method == "GET" || request.method == "HEAD";
    if (!gets && !(api && (request.method == "POST" || request.method == "DELETE")))
      return no(405, "that is not done here");
    bool told = request.get_header_value_count("Content-Length") == 1;
    if (request.has_header("Transfer-Encoding") || (request.method == "POST" && !told))
      return no(411, "the length of what is sent has to be told beforehand");
    if (request.has_header("Content-Encoding")) return no(415, "what is sent must not be compressed");
    std::size_t most = gets                                                            ? 0
                       : request.path == "/api/mesh" || request.path == "/api/painted" ? kMostMesh
                                                                                       : kMostText;
    if (told && request.get_header_value<std::uint64_t>("Content-Length") > most)
      return no(413, "what is sent is too long");
    if (!api) return std::nullopt;
    std::string given = request.get_header_value("X-Frond-Token");
    // An img element sends no headers of ours.
    if (given.empty() && request.method == "GET") given = request.get_param_value("token");
    if (same(given, token_)) return std::nullopt;
    return no(403, kNoToken);
  }

  /// A handler for JSON that holds `doc`, a preset.
  using Ask = std::function<void(const Request&, Response&, const Json&, Doc)>;
  void post(const std::string& path, Ask ask) {
    server_.Post(path, [this, ask](const Request& request, Response& response) {
      Json question = Json::parse(request.body, nullptr, false);
      if (!question.is_object()) return send(response, 400, {{"error", "no JSON object"}});
      Doc doc;
      if (question.contains("doc")) {
        const Json& given = question["doc"];
        if (!given.is_object() || !given.value("text", Json()).is_string() ||
            !given.value("file", Json()).is_string())
          return send(response, 400, {{"error", "doc wants text and file"}});
        auto path_of = documents_.readable(given["file"].get<std::string>());
        if (!path_of)
          return send(response, 403, {{"error", "the file is in no folder that the studio may read"}});
        doc = {given["text"].get<std::string>(), *path_of};
      }
      ask(request, response, question, std::move(doc));
    });
  }

  void add_routes() {
    server_.set_pre_routing_handler([this](const Request& request, Response& response) {
      std::optional<Refusal> no = refusal(request);
      if (!no) return httplib::Server::HandlerResponse::Unhandled;
      send(response, no->status, no->body);
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
    server_.Get("/api/ping", [this](const Request&, Response& response) {
      send(response, 200,
           {{"ok", true}, {"started", started_}, {"kept", scenes_.kept()}, {"room", options_.memory}});
    });
    server_.Get("/api/start", [this](const Request&, Response& response) {
      // The schema, which is most of it, is written once.
      static const std::string schema = ",\"schema\":" + serialize(preset_schema()) + "}";
      send(response, 200,
           {{"started", started_},
            {"machine", {{"cores", thread_count()}, {"farm", find_program("sbatch").has_value()}}},
            {"symbols", symbols_json()},
            {"preset", documents_.opened()},
            {"presets", documents_.shipped()},
            {"strips", documents_.strips()}});
      response.body.replace(response.body.size() - 1, 1, schema);
    });
    server_.Get("/api/preset", [this](const Request& request, Response& response) {
      Result<Json> read = documents_.read(request.get_param_value("file"));
      if (!read) return send(response, 403, {{"error", read.errors().front().text()}});
      send(response, 200, *read);
    });
    server_.Get("/api/disk", [this](const Request& request, Response& response) {
      send(response, 200, {{"disk", documents_.disk(request.get_param_value("file"))}});
    });
    server_.Get("/api/files",
                [this](const Request&, Response& response) { send(response, 200, documents_.own()); });
    server_.Get("/api/look", [this](const Request& request, Response& response) {
      Result<std::string> look = scenes_.look(request.get_param_value("file"));
      if (!look) return void(response.status = 204);  // a 404 would stand on the browser's console as a fault
      response.set_content(*look, "image/png");
    });
    server_.Get(R"(/api/(gallery|strip|docs)/(.+))", [this](const Request& request, Response& response) {
      const char* type = request.matches[1] == "docs" ? "text/plain; charset=utf-8" : "image/jpeg";
      send_picture(response, documents_.leaf(request.matches[1].str(), request.matches[2]), type);
    });
    auto tell = [](Response& response, const std::optional<Refusal>& no, const Json& saved) {
      no ? send(response, no->status, no->body) : send(response, 200, saved);
    };
    post("/api/save", [this, tell](const Request&, Response& response, const Json& question, Doc doc) {
      std::string file = question.at("file").get<std::string>();
      std::string disk = question.contains("disk") && question["disk"].is_string()
                             ? question["disk"].get<std::string>()
                             : "";
      if (doc.file.empty()) return send(response, 400, {{"error", "doc is missing"}});
      if (!question.value("force", false))
        if (Result<Preset> preset = documents_.preset(doc); !preset)
          return send(response, 422, {{"errors", errors_json(preset.errors())}});
      Json saved;
      tell(response, documents_.save(file, doc, disk, question.value("overwrite", false), saved), saved);
    });
    server_.Get("/api/painted", [this](const Request& request, Response& response) {
      documents_.restore(request.get_param_value("file"));
      auto file = documents_.readable(request.get_param_value("file"));
      if (!file || file->extension() != ".png")
        return send(response, 403, {{"error", "no such picture may be read"}});
      send_picture(response, read_file(*file), "image/png");
    });
    server_.Post("/api/painted", [this, tell](const Request& request, Response& response) {
      if (!request.body.starts_with("\x89PNG"))
        return send(response, 400, {{"error", "the file is no picture"}});
      Json saved;
      tell(response,
           documents_.add_file(request.get_param_value("name"), ".png", request.body,
                               request.get_param_value("of"), saved),
           saved);
    });
    server_.Post("/api/mesh", [this, tell](const Request& request, Response& response) {
      const httplib::MultipartFormData mesh = request.get_file_value("mesh");
      std::map<std::string, std::string> beside;
      for (auto [at, end] = request.files.equal_range("beside"); at != end; ++at)
        beside.emplace(at->second.filename, at->second.content);
      Json saved;
      tell(response,
           documents_.add_mesh(mesh.filename, mesh.content, beside, request.get_param_value("of"), saved),
           saved);
    });
  }

  void add_scenes() {
    post("/api/scene", [this](const Request& request, Response& response, const Json& question, Doc doc) {
      send(response, scenes_.view(doc, question, request.get_param_value("session"), sequence_of(request)));
    });
    server_.Get("/api/scene", [this](const Request& request, Response& response) {
      send(response, 200, scenes_.progress(request.get_param_value("session")));
    });
    server_.Delete("/api/scene", [this](const Request& request, Response& response) {
      scenes_.leave(request.get_param_value("session"), sequence_of(request));
      send(response, 200, {{"ok", true}});
    });
    post("/api/pick", [this](const Request&, Response& response, const Json& question, Doc doc) {
      send(response, scenes_.pick(doc, question));
    });
    post("/api/derive", [this](const Request&, Response& response, const Json& question, Doc doc) {
      send(response, scenes_.derive(doc, question));
    });
    using Act = Answer (*)(const Documents&, const Json&);
    for (auto [path, act] : {std::pair<const char*, Act>("/api/grammar", grammar_files),
                             {"/api/grammar/change", changed_grammar}})
      post(path, [this, act](const Request&, Response& response, const Json& question, Doc) {
        send(response, act(documents_, question));
      });
    post("/api/ball", [this](const Request&, Response& response, const Json& question, Doc doc) {
      Result<std::string> ball = scenes_.ball(doc, index_in(question, "entry", 0));
      if (!ball) return void(response.status = 204);  // as of /api/look
      response.set_content(*ball, "image/png");
    });
    post("/api/trace", [this](const Request&, Response& response, const Json& question, Doc doc) {
      send(response, scenes_.trace(doc, question));
    });
    server_.Get(R"(/api/picture/([A-Za-z0-9_.-]+))", [this](const Request& request, Response& response) {
      send_picture(response, scenes_.picture(request.matches[1]), "image/png");
    });
  }

  void add_renders() {
    post("/api/render", [this](const Request&, Response& response, const Json& question, Doc doc) {
      Result<std::string> id = renders_.begin(std::move(doc), time_in(question), size_in(question),
                                              question.value("quality", "draft"));
      if (!id) return send(response, 422, {{"errors", errors_json(id.errors())}});
      send(response, 200, {{"id", *id}});
    });
    post("/api/export", [this](const Request&, Response& response, const Json& question, Doc doc) {
      auto path = export_doc(documents_, options_.home, doc, export_order(question));
      if (!path) return send(response, 422, {{"errors", errors_json(path.errors())}});
      send(response, 200, {{"file", path->string()}});
    });
    post("/api/export/size", [this](const Request&, Response& response, const Json& question, Doc doc) {
      send(response, export_size(documents_, scenes_, doc, export_order(question)));
    });
    server_.Get("/api/renders",
                [this](const Request&, Response& response) { send(response, 200, renders_.list()); });
    auto nothing = [](Response& response) { send(response, 404, {{"error", "there is no such render"}}); };
    server_.Get(R"(/api/render/(\d+))", [this, nothing](const Request& request, Response& response) {
      std::optional<Json> state = renders_.state(request.matches[1]);
      state ? send(response, 200, *state) : nothing(response);
    });
    server_.Get(R"(/api/render/(\d+)/doc)", [this, nothing](const Request& request, Response& response) {
      std::optional<Doc> doc = renders_.doc(request.matches[1]);
      doc ? send(response, 200, {{"text", doc->text}, {"file", doc->file.string()}}) : nothing(response);
    });
    server_.Get(R"(/api/render/(\d+)/picture)", [this](const Request& request, Response& response) {
      send_picture(response, renders_.picture(request.matches[1]), "image/png");
    });
    server_.Delete(R"(/api/render/(\d+))", [this, nothing](const Request& request, Response& response) {
      renders_.cancel(request.matches[1]) ? send(response, 200, {{"ok", true}}) : nothing(response);
    });
  }

  void add_films() {
    post("/api/film", [this](const Request&, Response& response, const Json& question, Doc doc) {
      FilmOrder order;
      order.size = size_in(question);
      order.quality = question.value("quality", order.quality), order.frames = question.value("range", "");
      order.rough = question.value("rough", order.rough), order.farm = question.value("farm", order.farm);
      Result<std::string> id = films_.begin(doc, order);
      if (!id) return send(response, 422, {{"errors", errors_json(id.errors())}});
      send(response, 200, {{"id", *id}});
    });
    post("/api/moment", [this](const Request&, Response& response, const Json& question, Doc doc) {
      Result<std::string> look = scenes_.moment(doc, time_in(question));
      if (!look) return void(response.status = 204);  // as of /api/look
      response.set_content(*look, "image/png");
    });
    server_.Get("/api/films",
                [this](const Request&, Response& response) { send(response, 200, films_.list()); });
    auto nothing = [](Response& response) { send(response, 404, {{"error", "there is no such film"}}); };
    server_.Get(R"(/api/film/([\w-]+))", [this, nothing](const Request& request, Response& response) {
      std::optional<Json> state = films_.state(request.matches[1]);
      state ? send(response, 200, *state) : nothing(response);
    });
    server_.Get(
        R"(/api/film/([\w-]+)/([\w.]+))", [this, nothing](const Request& request, Response& response) {
          std::optional<std::filesystem::path> file = films_.file(request.matches[1], request.matches[2]);
          if (!file && request.matches[2] == "watch.png")
            return void(response.status = 204);  // it comes and goes
          file ? send_file(response, *file) : nothing(response);
        });
    using Act = bool (Films::*)(const std::string&);
    for (auto [name, act] : {std::pair<const char*, Act>("pause", &Films::pause), {"resume", &Films::resume}})
      server_.Post(fmt::format(R"(/api/film/([\w-]+)/{})", name), [this, nothing, act](const Request& request,
                                                                                       Response& response) {
        (films_.*act)(request.matches[1]) ? send(response, 200, {{"ok", true}}) : nothing(response);
      });
    server_.Delete(R"(/api/film/([\w-]+))", [this, nothing](const Request& request, Response& response) {
      films_.remove(request.matches[1]) ? send(response, 200, {{"ok", true}}) : nothing(response);
    });
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
