"""What the site has beside docs/*.md: the pages that are made from the program, the headers and the page's own words,
the pictures of the gallery, equations and looks. A hook of MkDocs."""

import inspect
import os
import pathlib
import re
import shlex
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree

from mkdocs.structure.files import File

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = ROOT / "docs" / "site"
KATEX = pathlib.Path("/usr/share/javascript/katex")
LAB = ROOT / "build/page/cromer-lab.html"
FORGE = {"CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md", "data/README.md": "data.md"}


def program(*words, **options):
    return subprocess.run([os.environ["CROMER_PROGRAM"], *words], check=True, capture_output=True, text=True, **options).stdout


# The pages of the commands, from the option tables.

def command_pages():
    parts = re.split(r"^# (?=cromer )", program("help", "--markdown"), flags=re.M)
    pages = {"commands/index.md": re.sub(r"`cromer (\w+)`", r"[`cromer \1`](\1.md)", parts[0])}
    for part in parts[1:]:
        name = part.split("\n", 1)[0].removeprefix("cromer ")
        pages[f"commands/{name}.md"] = "# " + part
    return pages


# The glossary, from the words of the page.

TITLES = {"chosen": "choice of a law (BIC)", "simulated": "simulated decay rate", "repaired": "spikes and gaps", "rms": "root mean square",
          "reynolds": "Reynolds number", "van_der_pol": "Van der Pol's term", "interval": "95 % interval", "free_part": "free part",
          "uncertainty": "uncertainty (±)", "friction": "dry friction", "cubic": "cubic spring", "quadratic": "quadratic spring",
          "odd_quadratic": "odd quadratic spring", "quintic": "quintic spring", "method": "method of integration"}


def with_words_of_the_page(page):
    """The table of the glossary with the entries that the page explains, in the order of the words."""
    words = (ROOT / "apps/web/src/words/en/glossary.ts").read_text()
    entries = re.findall(r"^  (\w+): '(.*)',?$", words, re.M)
    assert len(entries) > 20 and set(TITLES) <= {name for name, _ in entries}
    head, rows = page.split("|---|---|\n")
    rows = rows.splitlines() + [f"| {TITLES.get(name, name.replace('_', ' '))} | {text} |" for name, text in entries]
    return head + "|---|---|\n" + "\n".join(sorted(rows, key=str.lower)) + "\n"


# The public headers, from what Doxygen reads in them.

def plain(element):
    """The text of an element, in one line; code in backticks."""
    if element is None:
        return ""
    text = element.text or ""
    for child in element:
        inner = plain(child)
        text += (f"`{inner}`" if child.tag == "computeroutput" and inner else inner) + (child.tail or "")
    return " ".join(text.split())


def said(element):
    text = " ".join(filter(None, (plain(element.find("briefdescription")), plain(element.find("detaileddescription")))))
    pieces = re.split(r"(`[^`]*`)", text)
    return "".join(piece if piece.startswith("`") else re.sub(r"[<*_]", lambda c: "\\" + c[0], piece) for piece in pieces)


def code(element):
    """C++ as people write it."""
    return re.sub(r" ?([<>]) ?", r"\1", plain(element)).replace(" &", "&").replace(">const", "> const")


def cell(text):
    return text.replace("|", "\\|")


def signature(function):
    arguments = ", ".join(f"{code(p.find('type'))} {plain(p.find('declname'))}".strip()
                          + (f" = {plain(p.find('defval'))}" if p.find("defval") is not None else "")
                          for p in function.findall("param"))
    kept = " const" if function.get("const") == "yes" else ""
    return re.sub(r"\bCROMER_API ", "", f"{code(function.find('type'))} {plain(function.find('name'))}({arguments}){kept};").strip()


def shown(member):
    """Not operators, constructors and what is private."""
    own_type = plain(member.find("type")) != ""
    return member.get("prot") == "public" and own_type and not plain(member.find("name")).startswith("operator")


def functions(members):
    out = ""
    for each in members:
        if each.get("kind") == "function" and shown(each):
            out += f"\n```cpp\n{signature(each)}\n```\n\n{said(each)}\n"
    return out


def type_page(compound):
    name = code(compound.find("compoundname")).removeprefix("cromer::")
    out = f"\n### {name}\n\n{said(compound)}\n"
    members = compound.findall("sectiondef/memberdef")
    fields = [each for each in members if each.get("kind") == "variable" and each.get("prot") == "public"
              and "core::" not in plain(each.find("type"))]
    if fields:
        out += "\n| field | type | what it is |\n|---|---|---|\n"
        for each in fields:
            value = plain(each.find("initializer")).replace("{}", "").removeprefix("=").strip()
            name = plain(each.find("name")) + (f" = {value}" if value else "")
            out += f"| `{cell(name)}` | `{cell(code(each.find('type')))}` | {cell(said(each))} |\n"
    return out + functions(members)


def header_pages():
    with tempfile.TemporaryDirectory() as folder:
        settings = (HERE / "Doxyfile").read_text() + f"\nINPUT = include/cromer\nOUTPUT_DIRECTORY = {folder}\n"
        subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=ROOT, check=True)
        xml = pathlib.Path(folder) / "xml"
        read = lambda name: ElementTree.parse(xml / f"{name}.xml").getroot().find("compounddef")
        free = read("namespacecromer").findall("sectiondef/memberdef")
        types = [read(each.get("refid")) for each in read("namespacecromer").findall("innerclass")]
        order = re.findall(r"#include <cromer/(\w+\.h)>", (ROOT / "include/cromer/cromer.h").read_text())
        order = [each for each in order if (ROOT / "include/cromer" / each).exists()]
        out = "# The C++ interface\n\n`#include <cromer/cromer.h>` brings all of it but the last, which is plain C for other languages. [The library](../library.md) says how to build with it, and shows it at work.\n"
        for header in order:
            path = f"include/cromer/{header}"
            here = [each for each in free if each.find("location").get("file") == path]
            mine = [each for each in types if each.find("location").get("file") == path]
            head = re.match(r"(?:// .*\n)+", (ROOT / path).read_text())
            about = " ".join(line.removeprefix("// ") for line in head[0].splitlines()) if head else ""
            out += f"\n## cromer/{header}\n\n{about}\n" + functions(here)
            for each in sorted(mine, key=lambda each: int(each.find("location").get("line"))):
                out += type_page(each)
            for each in here:
                if each.get("kind") == "enum":
                    out += f"\n### {plain(each.find('name'))}\n\n{said(each)}\n\n| value | what it is |\n|---|---|\n"
                    out += "".join(f"| `{plain(v.find('name'))}` | {cell(said(v))} |\n" for v in each.findall("enumvalue"))
                elif each.get("kind") == "typedef":
                    out += f"\n### {plain(each.find('name'))}\n\n```cpp\n{plain(each.find('definition'))};\n```\n\n{said(each)}\n"
        return out + f"\n## cromer/c.h\n\n```c\n{(ROOT / 'include/cromer/c.h').read_text()}```\n"


# The interface of Python, from its docstrings.

def python_page():
    import cromer
    out = "# The Python interface\n\n[Cromer in Python](../python.md) shows it at work. In brackets beside an argument: first its unit, last its default.\n\n"
    types = re.findall(r"^#: (.*)\n(\w+) = ", (ROOT / "python/cromer/_types.py").read_text(), re.M)
    out += "| type | what it may be |\n|---|---|\n" + "".join(f"| `{name}` | {text} |\n" for text, name in types)
    verbs = [name for name in cromer.__all__ if inspect.isfunction(getattr(cromer, name))]
    verbs.sort(key=lambda name: inspect.unwrap(getattr(cromer, name)).__code__.co_firstlineno)
    for title, names in (("The verbs", verbs), ("What they give back", [n for n in cromer.__all__ if n not in verbs and n != "__version__"])):
        out += f"\n## {title}\n" + "".join(f"\n::: cromer.{name}\n    options:\n      heading_level: 3\n" for name in names)
    return out


# The gallery: each picture is drawn by the command above it.

def pictures(page):
    """Draws them into a folder that lasts as long as the build; their names, and their files."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="cromer-gallery-"))
    for name in ("data", "studies"):
        (folder / name).symlink_to(ROOT / name)
    for block in re.findall(r"```sh\n(.*?)```", page, re.S):
        for command in block.replace("\\\n", " ").splitlines():
            program(*shlex.split(command)[1:], cwd=folder)
    return {each.name: each for each in sorted(folder.glob("*.svg"))}


def with_pictures(page):
    def after(block):
        drawn = re.findall(r"--plot (\S+\.svg)", block[0])
        return block[0] + "".join(f"\n\n![]({name})" for name in drawn)

    return re.sub(r"```sh\n.*?```", after, page, flags=re.S)


def for_the_site(path, text):
    """Links to what lies beside docs/ on a forge, as the site has it."""
    for there, here in FORGE.items():
        text = text.replace(f"](../{there}", f"]({here}")
    if path in FORGE.values():
        text = re.sub(r"\]\(docs/", "](", text)
    return text


def with_the_lab(page):
    """The start with a way into the page, where it has been built."""
    head, mark, rest = page.partition("\n![")
    return head + "\n[Open the lab](cromer-lab.html){ .md-button .md-button--primary }\n" + mark + rest if LAB.exists() else page


def on_config(config):
    pages = command_pages()
    for section in config.nav:
        for reference in section.get("Reference", []):
            if "Commands" in reference:
                reference["Commands"] = list(pages)
    config["cromer_pages"] = pages
    return config


def on_files(files, config):
    made = dict(config["cromer_pages"])
    made["api/cpp.md"] = header_pages()
    made["api/python.md"] = python_page()
    for there, here in FORGE.items():
        made[here] = (ROOT / there).read_text()
    for path, text in made.items():
        files.append(File.generated(config, path, content=text))
    gallery = pictures((ROOT / "docs/gallery.md").read_text())
    taken = {f"assets/{each.name}": each for each in (HERE / "look.css", HERE / "equations.js", HERE / "iframe-worker.js")}
    taken |= {f"assets/katex/{each.relative_to(KATEX)}": each
              for each in (KATEX / "katex.min.js", KATEX / "katex.min.css", *KATEX.glob("fonts/*.woff2"))}
    lab = {LAB.name: LAB} if LAB.exists() else {}
    for path, source in (gallery | taken | lab).items():
        files.append(File.generated(config, path, abs_src_path=str(source.resolve())))
    return files


def on_page_markdown(markdown, page, config, files):
    path = page.file.src_uri
    if page.parent is None:  # alone in its tab
        page.meta["hide"] = ["navigation"]
    if path == "changelog.md":  # it has every word
        page.meta["search"] = {"exclude": True}
    completed = {"index.md": with_the_lab, "gallery.md": with_pictures, "glossary.md": with_words_of_the_page}.get(path, str)
    return for_the_site(path, completed(markdown))


def on_post_build(config):
    """Nothing that a browser loads by itself comes from elsewhere. The page for what is not found would need a server."""
    (pathlib.Path(config.site_dir) / "404.html").unlink(missing_ok=True)
    loads = re.compile(r"""<(?:script|img|iframe|source|video|audio)\b[^>]*\bsrc=["']?(?:https?:)?//[^>]*>|<link\b(?![^>]*rel=["']?canonical)[^>]*\bhref=["']?(?:https?:)?//[^>]*>""")
    for page in pathlib.Path(config.site_dir).rglob("*.html"):
        found = loads.search(page.read_text())
        if found:
            raise SystemExit(f"{page} asks a foreign host: {found[0]}")
    for style in pathlib.Path(config.site_dir).rglob("*.css"):
        found = re.search(r"(?:url\(|@import\s)[\"']?(?:https?:)?//[^)\s]*", style.read_text())
        if found:
            raise SystemExit(f"{style} asks a foreign host: {found[0]}")
