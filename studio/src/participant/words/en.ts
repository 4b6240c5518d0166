/** What participants read in English. {places} are filled. */

export const en = {
  demo: "Demonstration: nothing here is a real study.",
  go_on: "Go on",
  back: "Back",
  begin: "Begin",
  try_again: "Try again",
  language: "Language",

  consent_title: "Taking part",
  consent_box: "I have read this, and I agree to take part.",
  consent_missing: "Please tick the box if you agree.",
  consent_agree: "Agree and go on",
  consent_decline: "I do not want to take part",
  declined_title: "You are not taking part",
  declined: "That is quite all right. Nothing was kept. You can close this page.",

  groups_title: "About you",
  groups_choose: "Please choose",
  groups_missing: "Please answer every question.",
  notes_title: "Before you begin",

  loading: "Fetching the pictures",
  loading_of: "{here} of {all} pictures are here",

  screen_title: "Your screen",
  screen_intro:
    "Colours and sizes look different on every screen. The next pages find out what yours is like. " +
    "This takes about two minutes.",
  screen_advice:
    "Please sit as you usually do. Turn off night modes that make the screen yellowish, set the " +
    "brightness so that white is comfortable, and keep lamps and windows from reflecting in it.",
  screen_step: "Screen check, step {n} of {all}",

  window_title: "The window is rather small",
  window_small:
    "This study needs a window of at least {wide} × {high} pixels. Yours has {width} × {height}. " +
    "Please make it larger, turn the device sideways, or use a larger screen.",
  window_now: "Now {width} × {height} pixels",
  window_large: "Now it is large enough.",
  window_anyway: "Go on with this window",

  full_title: "Full screen",
  full: "The pictures are best seen with nothing around them.",
  full_leave: "The key Esc brings you back at any time.",
  full_leave_touch: "You can leave it at any time; your browser shows how.",
  full_enter: "Go to full screen",
  full_without: "Go on without",

  card_title: "How large is your screen?",
  card:
    "Hold a bank card, or any card of that size, against the screen. Make the drawing exactly as " +
    "large: drag its corner, move the slider, or use the arrow keys.",
  card_touch:
    "Hold a bank card, or any card of that size, against the screen. Make the drawing exactly as " +
    "large: drag its corner or move the slider.",
  card_upright: "Hold the card upright, its lower corner on that of the drawing.",
  card_turn: "If the card is wider than the drawing can be, turn the phone on its side.",
  card_slider: "Size of the drawing",
  card_done: "It is as large as the card",
  card_none: "I have no card at hand",

  distance_title: "How far are you from the screen?",
  distance:
    "Close your right eye, or cover it with your hand. With the left eye look at the square " +
    "all the time. A dot moves away from it to the left; at some place it vanishes. Press the button or the " +
    "space bar at the moment it does.",
  distance_touch:
    "Close your right eye, or cover it with your hand. With the left eye look at the square " +
    "all the time. A dot moves away from it to the left; at some place it vanishes. Touch the button " +
    "at the moment it does.",
  distance_again:
    "That would be {cm} cm from your eyes to the screen, which can hardly be. Please do it once more, " +
    "with the left eye on the square all the time. Try {n} of {all}",
  distance_sure:
    "{cm} cm can hardly be. Please change it, or press the button again if it is right.",
  distance_try: "Try {n} of {all}",
  distance_start: "Start the dot",
  distance_gone: "It vanished now",
  distance_type: "Type the distance instead",
  distance_typed: "Measure or estimate the distance from your eyes to the screen.",
  distance_cm: "Distance in centimetres",
  distance_range: "Please type a number from 10 to 300.",
  distance_unknown: "I do not know",
  distance_missed: "The dot reached the end. Please try once more.",

  gamma_title: "Middle tones",
  gamma:
    "Move the slider until the disc in the middle is as bright as the stripes around it. " +
    "It helps to half close your eyes, or to lean back, so that the stripes blur.",
  gamma_slider: "Brightness of the disc",
  gamma_done: "They look the same",

  dark_title: "Dark tones",
  dark:
    "On black there are eight patches, some so dark that they may not be seen. " +
    "Choose the darkest patch that you can just see.",
  dark_patch: "Patch {n}",
  dark_none: "I see none of them",

  contrast_title: "Fine shades",
  contrast:
    "You will see a ring with a gap, fainter each time. Say where the gap is: press an arrow key or a " +
    "button. If you cannot see it, guess.",
  contrast_touch:
    "You will see a ring with a gap, fainter each time. Say where the gap is by a button. " +
    "If you cannot see it, guess.",
  no_medical: "This is no medical test. It says nothing certain about your eyes.",
  contrast_question: "Where is the gap?",
  contrast_of: "Ring {n} of {all}",
  up: "Above",
  down: "Below",
  left: "Left",
  right: "Right",

  colour_title: "Colours",
  colour:
    "You will see discs made of dots. In some there is a digit in another colour. Say which: press " +
    "its key or a button. If you see none, say so.",
  colour_touch:
    "You will see discs made of dots. In some there is a digit in another colour. Say which by a " +
    "button. If you see none, say so.",
  colour_question: "Which digit do you see?",
  colour_of: "Disc {n} of {all}",
  colour_none: "None",

  instructions_title: "What to do",
  instructions_keys:
    "Click the picture that you choose, or press ← for the left one and → for the right one.",
  instructions_ties: "Where you see no difference, press ↓ or =, or the button below the pictures.",
  instructions_touch: "Touch the picture that you choose.",
  instructions_touch_ties: "Touch “{tie}” below the pictures where you see none.",
  instructions_training: "First come {n} pairs for practice.",
  instructions_begin: "Begin practice",
  training_over_title: "That was the practice",
  training_over: "Now it begins. From here on your answers count: {n} pairs.",
  resumed_title: "Welcome back",
  resumed: "Your answers so far are kept. You go on with pair {n} of {all}.",
  resumed_training:
    "Your answers so far are kept. You go on with the practice, pair {n} of {all} there.",
  adapt_text: "Please look at this grey until the next pair comes.",
  adapt_left: "{n} s",

  left_picture: "Left picture",
  right_picture: "Right picture",
  tie: "No difference",
  pair_of: "{n} of {all}",
  training_of: "Practice: {n} of {all}",
  pair_keys: "Keys ← and →",
  pair_keys_tie: "Keys ← and →, no difference ↓",
  pair_early: "Please look a moment longer.",

  break_title: "A short break",
  break_next: "The next question",
  break_text: "{n} of {all} pairs are done. Rest your eyes for a moment; look into the distance.",
  stop: "I want to stop",
  stop_title: "Stopping",
  stop_text:
    "You can stop for now and go on later in this browser, or withdraw: then your answers will not be counted.",
  stop_later: "Go on later",
  stop_withdraw: "Withdraw",
  later_title: "See you later",
  later: "Your answers are kept. Open the same page again in this browser to go on.",
  withdrawn_title: "You have withdrawn",
  withdrawn: "Your answers will not be counted. Thank you for your time. You can close this page.",

  offline: "Not connected. Your answers are kept here and sent when the connection is back.",
  sending_title: "Almost done",
  sending: "{n} answers are still on their way. Please leave this page open.",
  thanks_title: "Thank you",
  thanks: "All answers are stored. You can close this page.",
  thanks_stored: "All answers are stored.",
  thanks_return: "Back to where you came from",
  thanks_return_use:
    "Please press the button below, so that the site from which you came knows that you have finished.",
  thanks_code: "Give this completion code where you signed up for the study:",
  thanks_code_too: "If it asks for a completion code, it is this one:",
  thanks_next: "Another person at this computer",
  refused_title: "This screen does not suit the study",
  refused:
    "Thank you for your patience. The pictures cannot be shown on this screen as the study needs. " +
    "You are welcome to try on another one.",
  refused_again: "Check the screen again",
  paused_title: "The study is paused",
  paused: "Please come back later. What you have answered is kept.",
  closed_title: "The study is over",
  closed: "Thank you for your interest. No more answers are taken.",
  invited_title: "An invitation is needed",
  invited: "Please open the link that you were sent. It ends with a # and a long code.",
  unknown_title: "This link is not valid",
  unknown:
    "Perhaps it was cut off when it was copied, or it was withdrawn. Please open the whole link, or ask " +
    "whoever sent it to you.",
  stopped_title: "This sitting has ended",
  stopped: "The study takes no more answers from here. Please ask whoever invited you.",
  tabs_title: "Already open",
  tabs: "This study is open in another tab or window. Please go on there, or close it and try again here.",
  broken_title: "Something went wrong",
  broken:
    "Your answers so far are kept. Please load the page again; if that does not help, tell whoever " +
    "invited you.",
  unreachable: "The study cannot be reached. We keep trying.",
} as const;
