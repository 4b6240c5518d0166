/** Which of the pearls and scenes that come with Nacreous are shown first. */

/** Families and masters are one click below. */
export const FEATURED = [
  "akoya-rg",
  "akoya-r",
  "akoya-g",
  "akoya-pink",
  "akoya-cream",
  "akoya-dyed-blue",
  "akoya-thin",
  "paper",
  "paper-summer-harvest",
  "south-sea-white",
  "south-sea-gold",
  "tahitian",
];

export const SCENE_ORDER = [
  "north-window-black",
  "north-window-white",
  "aurora",
  "booth",
  "paper",
  "two-tier",
];
