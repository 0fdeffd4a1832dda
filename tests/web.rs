//! The page's parts in a real browser: the projection, path data, what the browser keeps, and that the core
//! does there what it does natively.
#![cfg(target_arch = "wasm32")]
#![allow(missing_docs, clippy::unwrap_used)]

use std::cell::RefCell;
use std::rc::Rc;

use line_maze_lab::explorer::name::Name;
use line_maze_lab::geometry::{Heading, Point};
use line_maze_lab::gesture::{nearest_cell, nearest_point};
use line_maze_lab::maze::generate::{Recipe, generate};
use line_maze_lab::maze::{Bounds, samples, text};
use line_maze_lab::route::TurnList;
use line_maze_lab::run::explore;
use line_maze_lab::settings::{Order, Settings};
use line_maze_lab::share::{self, Shared};
use line_maze_lab::web::storage::{self, Theme};
use line_maze_lab::web::viewport::{Overlays, Size, Viewport};
use line_maze_lab::web::{paths, rescue};
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

const SIZE: Size = Size { w: 800.0, h: 600.0 };
const VIEW: Viewport = Viewport { x: 3.0, y: -2.5, scale: 40.0 };

fn near((ax, ay): (f64, f64), (bx, by): (f64, f64)) -> bool {
    (ax - bx).abs() < 1e-9 && (ay - by).abs() < 1e-9
}

#[wasm_bindgen_test]
fn there_and_back_is_the_same_place() {
    for (x, y) in [(0.0, 0.0), (3.0, -2.5), (-7.25, 11.5)] {
        let (px, py) = VIEW.to_screen(SIZE, x, y);
        assert!(near(VIEW.to_lattice(SIZE, px, py), (x, y)));
    }
}

#[wasm_bindgen_test]
fn north_is_up_and_the_middle_is_the_middle() {
    assert_eq!(VIEW.to_screen(SIZE, 3.0, -2.5), (400.0, 300.0));
    assert!(VIEW.to_screen(SIZE, 3.0, -1.5).1 < 300.0);
}

#[wasm_bindgen_test]
fn a_fitted_lattice_lies_in_the_picture() {
    let bounds = Bounds::new(Point::new(-4, 2), Point::new(20, 9)).unwrap();
    let view = Viewport::fit(bounds, SIZE, 90.0);
    for corner in [bounds.sw(), bounds.ne()] {
        let (px, py) = view.to_screen(SIZE, f64::from(corner.x), f64::from(corner.y));
        assert!((0.0..=SIZE.w).contains(&px) && (0.0..=SIZE.h).contains(&py));
    }
}

#[wasm_bindgen_test]
fn a_fitted_lattice_lies_beside_what_stands_on_the_picture() {
    for size in [SIZE, Size { w: 364.0, h: 304.0 }, Size { w: 300.0, h: 700.0 }, Size { w: 1200.0, h: 300.0 }]
    {
        let over = Overlays::on(size);
        for (w, h) in [(2, 2), (3, 9), (6, 6), (9, 4), (20, 2), (40, 60), (200, 200)] {
            let bounds = Bounds::new(Point::new(-1, 3), Point::new(w - 2, h + 2)).unwrap();
            let view = Viewport::fit_beside(bounds, size, 100.0, over);
            let place = |at: Point| view.to_screen(size, f64::from(at.x), f64::from(at.y));
            let ((left, bottom), (right, top)) = (place(bounds.sw()), place(bounds.ne()));
            assert!(left > 0.0 && right < size.w && top > 0.0 && bottom < size.h, "{w} × {h} in {size:?}");
            assert!(right < size.w - over.upper.w || top > over.upper.h, "{w} × {h} in {size:?}: upper");
            assert!(
                right < size.w - over.lower.w || bottom < size.h - over.lower.h,
                "{w} × {h} in {size:?}: lower"
            );
        }
    }
    // Where it's free of them, it stands in the middle, and nothing makes it smaller.
    let small = Bounds::new(Point::new(0, 0), Point::new(2, 2)).unwrap();
    assert_eq!(
        Viewport::fit_beside(small, SIZE, 100.0, Overlays::on(SIZE)),
        Viewport::fit(small, SIZE, 100.0)
    );
}

#[wasm_bindgen_test]
fn zooming_keeps_the_place_under_the_pointer_and_moving_takes_it_along() {
    let pointer = (123.0, 456.0);
    let before = VIEW.to_lattice(SIZE, pointer.0, pointer.1);
    assert!(near(before, VIEW.zoomed(SIZE, 1.7, pointer).to_lattice(SIZE, pointer.0, pointer.1)));
    let (px, py) = VIEW.to_screen(SIZE, 1.0, 1.0);
    assert!(near((px + 30.0, py - 12.0), VIEW.moved(30.0, -12.0).to_screen(SIZE, 1.0, 1.0)));
}

#[wasm_bindgen_test]
fn the_nearest_point_and_cell_are_under_the_pointer() {
    assert_eq!(nearest_point((1.4, -0.6)), Point::new(1, -1));
    assert_eq!(nearest_cell((2.1, 3.5)).0, (Point::new(2, 3), Heading::North));
    assert_eq!(nearest_cell((2.4, 2.9)).0, (Point::new(2, 3), Heading::East));
    assert_eq!(nearest_cell((-0.5, 0.1)).0, (Point::new(-1, 0), Heading::East));
}

#[wasm_bindgen_test]
fn cells_in_a_row_are_one_stroke() {
    let corners = (Point::new(0, 0), Point::new(3, 1));
    let row = paths::cells(corners, |at, heading| heading == Heading::East && at.y == 1 && at.x != 1);
    assert_eq!(row, "M0 -80H80M160 -80H320");
    let column = paths::cells(corners, |at, heading| heading == Heading::North && at.x == 2);
    assert_eq!(column, "M160 0V-160");
}

#[wasm_bindgen_test]
fn walls_stand_half_a_cell_outside_and_tiles_share_them() {
    let maze = text::parse("line-maze: 1\nkind: wall\n\n+---+   +\n|   |   |\n+---+   +\n").unwrap();
    let (bounds, has) = (maze.bounds(), |at, heading| maze.has_line(at, heading));
    let (sw, ne) = (bounds.sw(), bounds.ne());
    let whole = paths::walls(bounds, (sw, ne), has);
    // Below, above, left, between, right, and the post in the middle of the four squares.
    assert_eq!(whole, "M-40 40H200M-40 -120H200M-40 40V-120M120 40V-120M200 40V-120M40 -40h0");
    let (left, right) = (Point::new(1, 1), Point::new(2, 0));
    let parts = paths::walls(bounds, (sw, left), has) + &paths::walls(bounds, (right, ne), has);
    assert_eq!(parts.matches('M').count(), whole.matches('M').count() + 2, "{parts}");
    assert_eq!(paths::squares((sw, ne), |at| at.x < 2), "M-40 -40H120v80H-40zM-40 -120H120v80H-40z");
}

#[wasm_bindgen_test]
fn tiles_cover_the_lattice_once() {
    let bounds = Bounds::new(Point::new(-7, 3), Point::new(45, 30)).unwrap();
    let covered: i32 = paths::tiles(bounds).iter().map(|(a, b)| (b.x - a.x + 1) * (b.y - a.y + 1)).sum();
    assert_eq!(covered as usize, bounds.len());
}

#[wasm_bindgen_test]
fn the_same_seed_gives_the_same_maze_as_natively() {
    let maze = generate(&Recipe { seed: 1924, ..Recipe::default() }).unwrap();
    assert_eq!(text::write_drawing(&maze), include_str!("fixtures/generated-1924.maze"));
}

#[wasm_bindgen_test]
fn figure_3_1_is_solved_as_natively() {
    let trace = explore(&samples::figure_3_1(), &Settings::default()).unwrap();
    assert_eq!(trace.stops(), 25);
    assert_eq!(TurnList::of(&trace).unwrap().to_string(), "SSR");
}

#[wasm_bindgen_test]
fn a_link_brings_back_what_was_shared() {
    let settings = Settings { order: Order::Random(7), epsilon_ms: Some(120), ..Settings::default() };
    let shared =
        Shared { maze: samples::figure_2_4(), settings, explorer: Name::Book, stop: 6, solved: false };
    assert_eq!(share::decode(&share::encode(&shared).unwrap()).unwrap(), shared);
}

#[wasm_bindgen_test]
fn the_browser_keeps_maze_settings_and_theme() {
    let maze = generate(&Recipe { seed: 3, ..Recipe::default() }).unwrap();
    let text = text::write(&maze);
    storage::keep_maze(&text).unwrap();
    assert_eq!(storage::maze(), Some(text));
    let settings = Settings { order: Order::Random(9), node_max: 12, ..Settings::default() };
    storage::keep_settings(&settings, Name::LeftHand);
    assert_eq!(storage::settings(), settings);
    for theme in [Theme::Dark, Theme::Light, Theme::System] {
        storage::keep_theme(theme);
        assert_eq!(storage::theme(), theme);
    }
}

#[wasm_bindgen_test]
fn what_cannot_be_read_from_storage_is_as_at_first() {
    let local = web_sys::window().unwrap().local_storage().unwrap().unwrap();
    local.set_item("line-maze-lab/maze", "no maze at all").unwrap();
    local.set_item("line-maze-lab/settings", "order=XYZ\nepsilon=much\nnode_max=-3").unwrap();
    assert_eq!(storage::maze(), None);
    assert_eq!(storage::settings(), Settings::default());
    local.clear().unwrap();
}

#[wasm_bindgen_test]
fn a_panic_is_told_to_the_rescue_screen() {
    let told = Rc::new(RefCell::new(String::new()));
    let heard = Rc::clone(&told);
    let listener = Closure::<dyn FnMut(web_sys::CustomEvent)>::new(move |event: web_sys::CustomEvent| {
        *heard.borrow_mut() = event.detail().as_string().unwrap_or_default();
    });
    let window = web_sys::window().unwrap();
    let function = listener.as_ref().unchecked_ref();
    window.add_event_listener_with_callback("linemaze:panic", function).unwrap();
    rescue::tell("trace: index 26 of 25");
    window.remove_event_listener_with_callback("linemaze:panic", function).unwrap();
    assert!(told.borrow().starts_with("trace: index 26 of 25"), "{}", told.borrow());
}
