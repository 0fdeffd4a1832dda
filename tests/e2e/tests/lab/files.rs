//! Files in and out of the Draw room: save, open, import and export.

use anyhow::Result;
use e2e::{Button, Page, Setup, root};
use line_maze_lab::maze::micromouse::Form;
use line_maze_lab::maze::{Kind, Maze, file, text};
use serde_json::json;

use crate::drawing::{
    draw_room, figure_3_1, from_menu, has_cells, kept, kept_when, new_by_keys, new_walls, places,
};

#[tokio::test]
async fn a_maze_is_saved_and_opened_again() -> Result<()> {
    // The system's own dialog for files can't be used by a test: the field is put on the page instead.
    let chooser =
        "HTMLInputElement.prototype.click = function () { document.querySelector('main').append(this) };";
    draw_room(Setup::default().script(chooser), async |page| {
        let downloads = page.allow_downloads().await?;
        let path = places(page, &[(0, 3), (0, 3)]).await?;
        page.drag(&path, Button::Left).await?;
        page.press("Control+s").await?;
        let saved = downloads.file("the-run-of-the-book.maze").await?;
        assert_eq!(text::parse(&saved)?, figure_3_1()?);
        for (entry, file) in [
            ("Save .json", "the-run-of-the-book.json"),
            ("Export picture, SVG", "the-run-of-the-book.svg"),
            ("Export picture, PNG", "the-run-of-the-book.png"),
        ] {
            page.click("File ▾").await?;
            page.wait_for("[role=menu]").await?;
            page.click(entry).await?;
            assert!(downloads.bytes(file).await?.len() > 300, "{file}");
        }
        assert!(downloads.bytes("the-run-of-the-book.png").await?.starts_with(b"\x89PNG"));
        assert!(downloads.file("the-run-of-the-book.svg").await?.contains("<svg"));

        for file in ["the-run-of-the-book.maze", "the-run-of-the-book.json"] {
            new_by_keys(page, "3", "3").await?;
            has_cells(page, 0).await?;
            page.press("Control+o").await?;
            page.wait_for("input[type=file]").await?;
            page.choose_file("input[type=file]", &downloads.path(file)).await?;
            page.wait_for_text(".stage .bar", "The run of the book").await?;
            assert_eq!(kept(page).await?, saved, "{file}");
            page.run("document.querySelector('input[type=file]').remove()").await?;
        }
        Ok(())
    })
    .await
}

/// A maze of 16 × 16 squares that every micromouse form can say: finish in the centre.
async fn contest_maze(page: &Page) -> Result<Maze> {
    const DRAWN: &str = "line-maze: 1\ntitle: Contest\nkind: wall\nbounds: 0,0 15,15\nstart: 0,0 N\n\
        finish: 7,7 7,8 8,7 8,8\n\nlines:\n0,0 0,15 15,15 15,0 1,0 1,14 7,14 7,7 8,7 8,8 7,8\n";
    page.paste(DRAWN).await?;
    page.wait_for_text(".stage .bar", "Contest").await?;
    kept_when(page, |maze| maze.about.title == "Contest").await
}

#[tokio::test]
async fn micromouse_files_go_out_and_come_in_again() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        let downloads = page.allow_downloads().await?;
        let maze = contest_maze(page).await?;
        for form in Form::ALL {
            let (name, extension) = (file::name(&maze, form.extension()), form.extension());
            from_menu(page, &format!("Export micromouse .{extension}")).await?;
            let bytes = downloads.bytes(&name).await?;
            let native = file::write(&maze, file::Format::Micromouse(form))?;
            assert_eq!(bytes, native, "{name}");
            new_by_keys(page, "3", "3").await?;
            has_cells(page, 0).await?;
            // What a file holds counts, not what it is called.
            page.drop_file(&format!("dropped.{extension}"), &bytes).await?;
            page.wait_for_text(".toast", "Opened dropped").await?;
            let opened = kept_when(page, |maze| maze.kind == Kind::Wall).await?;
            assert!(opened.lines().eq(maze.lines()), "{name}");
            assert_eq!(opened.start(), maze.start());
            page.wait_for("#drawing svg.walls").await?;
            page.press("Escape").await?;
            page.press_times("Control+z", 2).await?;
            page.wait_for_text(".stage .bar", "Contest").await?;
        }
        page.screenshot("contest").await
    })
    .await
}

#[tokio::test]
async fn what_a_format_cannot_say_is_told_with_the_cure() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        for (entry, words) in [(".txt", "drawn as lines"), (".maz", "drawn as lines")] {
            from_menu(page, &format!("Export micromouse {entry}")).await?;
            page.wait_for_text(".toast[role=alert]", words).await?;
            page.press("Escape").await?;
            page.wait_for_no(".toast").await?;
        }
        new_walls(page, "4", "3").await?;
        for (entry, words) in [(".maz", "as high as it is wide")] {
            from_menu(page, &format!("Export micromouse {entry}")).await?;
            page.wait_for_text(".toast[role=alert]", words).await?;
        }
        page.screenshot("cannot-say").await?;
        page.press("Escape").await?;
        page.press("t").await?;
        from_menu(page, "Export micromouse .txt").await?;
        page.wait_for_text(".toast[role=alert]", "not east; turn it").await
    })
    .await
}

#[tokio::test]
async fn files_that_cannot_be_read_are_told_with_their_place() -> Result<()> {
    draw_room(Setup::default(), async |page| {
        let mut bytes = vec![0_u8; 256];
        bytes[17] = 1;
        let bad: [(&str, &[u8], &str); 4] = [
            ("odd.txt", b"o---o\n| S |\no-x-o\n", "line 3"),
            ("odd.num", b"0 0 1 1 1 1\n1 0 1 0 1 2\n", "line 2"),
            ("odd.map", b"+---+\n|   \n+---+\n", "line 2"),
            ("odd.maz", &bytes, "byte"),
        ];
        for (name, content, place) in bad {
            page.drop_file(name, content).await?;
            page.wait_for_text(".toast[role=alert]", name).await?;
            let said = page.text(".toast").await?.to_lowercase();
            assert!(said.contains(place), "{name}: {said}");
            page.press("Escape").await?;
            page.wait_for_no(".toast").await?;
        }
        for (mebibytes, words) in [(5, "at most"), (33, "a maze file has at most 32 MiB")] {
            let name = format!("huge-{mebibytes}.maze");
            let drop = "(name, mebibytes) => {
                const dataTransfer = new DataTransfer();
                dataTransfer.items.add(new File(['line-maze: 1\\n', ' '.repeat(mebibytes << 20)], name));
                document.querySelector('main').dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
            }";
            page.call(drop, &[json!(name), json!(mebibytes)]).await?;
            page.wait_for_text(".toast[role=alert]", &name).await?;
            page.wait_for_text(".toast[role=alert]", words).await?;
        }
        page.wait_for_text(".stage .bar", "The run of the book").await
    })
    .await
}

#[tokio::test]
async fn a_file_is_chosen_by_every_name() -> Result<()> {
    let chooser =
        "HTMLInputElement.prototype.click = function () { document.querySelector('main').append(this) };";
    draw_room(Setup::default().script(chooser), async |page| {
        page.press("Control+o").await?;
        page.wait_for("input[type=file]").await?;
        let accepted = page.attribute("input[type=file]", "accept").await?;
        for name in [".maze", ".json", ".txt", ".map", ".num", ".maz"] {
            assert!(accepted.split(',').any(|accepted| accepted == name), "{accepted}");
        }
        page.choose_file("input[type=file]", &root().join("mazes/cornell-6x4.maze").canonicalize()?).await?;
        page.wait_for("#drawing svg.walls").await
    })
    .await
}
