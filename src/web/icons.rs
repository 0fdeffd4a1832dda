//! The lab's pictograms, 20 × 20, drawn with the text's colour.

use leptos::prelude::*;

macro_rules! icons {
    ($($name:ident $data:literal)*) => {$(
        #[doc = concat!("`", stringify!($name), "`.")]
        pub fn $name() -> impl IntoView {
            view! { <svg viewBox="0 0 20 20" aria-hidden="true"><path d=$data /></svg> }
        }
    )*};
}

icons! {
    again "M16.5 10a6.5 6.5 0 11-2-4.7M16.5 2.5v4h-4"
    book "M10 5C8.2 3.3 5.5 3 2.5 3.2v12.3c3-.2 5.7.1 7.5 1.8 1.8-1.7 4.5-2 7.5-1.8V3.2C14.5 3 11.8 3.3 10 5zM10 5v12"
    close "M5 5l10 10M15 5L5 15"
    copy "M7 7h9.5v9.5H7zM13 7V5.5a2 2 0 00-2-2H5.5a2 2 0 00-2 2V11a2 2 0 002 2H7"
    differs "M4 7h12M4 13h12M13.5 3l-7 14"
    download "M10 3v9.5M6 9l4 4 4-4M3.5 16.5h13"
    erase "M8 16.5h9M3.5 11.5l7-7.5 5.5 5.2-7 7.3H7.3zM7.2 7.6l5.5 5.2"
    eye "M2 10s3-5.5 8-5.5S18 10 18 10s-3 5.5-8 5.5S2 10 2 10zM10 7.6a2.4 2.4 0 100 4.8 2.4 2.4 0 000-4.8"
    finish "M4 6h12v9H4zM4 6l12 9M16 6L4 15"
    halt "M5 5h10v10H5z"
    info "M10 2.5a7.5 7.5 0 100 15 7.5 7.5 0 000-15M10 9v5M10 6v.1"
    keyboard "M2.5 5h15v10h-15zM5.5 8h0M8.5 8h0M11.5 8h0M14.5 8h0M5.5 12h9"
    line "M3 16V5h10v8h4"
    minus "M4 10h12"
    moon "M16 11.5A6.5 6.5 0 118.5 4a5 5 0 007.5 7.5z"
    move_paper "M10 2v16M2 10h16M7.8 4L10 1.8 12.2 4M7.8 16l2.2 2.2 2.2-2.2M4 7.8L1.8 10 4 12.2M16 7.8l2.2 2.2-2.2 2.2"
    no "M6.5 2h7L18 6.5v7L13.5 18h-7L2 13.5v-7zM7.5 7.5l5 5M12.5 7.5l-5 5"
    ok "M10 2.5a7.5 7.5 0 100 15 7.5 7.5 0 000-15M6.8 10.4l2.3 2.3 4.2-5"
    pen "M4 16l.8-3.6L13.6 3.6l2.8 2.8-8.8 8.8zM11.8 5.4l2.8 2.8"
    open "M11 3.5h5.5V9M16 4l-7.5 7.5M8 5H4.5v10.5H15V12"
    plus "M10 4v12M4 10h12"
    redo "M13 4l4 4-4 4M16.5 8H8a4.5 4.5 0 000 9h4"
    screen "M2.5 3.5h15v10h-15zM10 13.5v3.5M6.5 17h7"
    settings "M3 6h8M15 6h2M3 14h2M9 14h8M13 3.8a2.2 2.2 0 100 4.4 2.2 2.2 0 000-4.4M7 11.8a2.2 2.2 0 100 4.4 2.2 2.2 0 000-4.4"
    share "M13.5 6.5a2.2 2.2 0 100-4.4 2.2 2.2 0 000 4.4M5.5 12.2a2.2 2.2 0 100-4.4 2.2 2.2 0 000 4.4M13.5 17.9a2.2 2.2 0 100-4.4 2.2 2.2 0 000 4.4M7.5 9l4-3.5M7.5 11l4 3.5"
    start "M10 8a4.5 4.5 0 100 9 4.5 4.5 0 000-9M10 8V1.8M7.4 4.2L10 1.6l2.6 2.6"
    sun "M10 6.5a3.5 3.5 0 100 7 3.5 3.5 0 000-7M10 2v1.5M10 16.5V18M2 10h1.5M16.5 10H18M4.3 4.3l1.1 1.1M14.6 14.6l1.1 1.1M15.7 4.3l-1.1 1.1M5.4 14.6l-1.1 1.1"
    system "M10 2.5a7.5 7.5 0 100 15 7.5 7.5 0 000-15M10 2.5v15M13 4v12M15.5 6v8"
    undo "M7 4L3 8l4 4M3.5 8H12a4.5 4.5 0 010 9H8"
    warn "M10 2.5L18.5 17h-17zM10 8v4M10 14.4v.1"

    to_start "M3 3h2.6v14H3zM17 3v14L7 10z"
    to_end "M17 3h-2.6v14H17zM3 3v14l10-7z"
    back "M14 3v14L4 10z"
    forward "M6 3v14l10-7z"
    play "M5 2.5v15L17.5 10z"
    pause "M4.5 3h4v14h-4zM11.5 3h4v14h-4z"
    next_event "M3 4v12l7-6zM14 6l4 4-4 4-4-4z"
}
