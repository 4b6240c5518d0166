/** What participants read in Japanese. */

import type { Words } from "./words";

export const ja: Words = {
  demo: "これはデモンストレーションです。実際の調査ではありません。",
  go_on: "次へ",
  back: "戻る",
  begin: "始める",
  try_again: "もう一度試す",
  language: "言語",

  consent_title: "参加のお願い",
  consent_box: "上記の説明を読み、参加に同意します。",
  consent_missing: "同意される場合は、チェックを入れてください。",
  consent_agree: "同意して次へ",
  consent_decline: "参加しません",
  declined_title: "参加を見送られました",
  declined:
    "ご検討いただき、ありがとうございました。何も保存されていません。このページを閉じていただいて結構です。",

  groups_title: "あなたについて",
  groups_choose: "選択してください",
  groups_missing: "すべての質問にお答えください。",
  notes_title: "始める前に",

  loading: "画像を読み込んでいます",
  loading_of: "画像 {all} 枚のうち {here} 枚を読み込みました",

  screen_title: "画面の確認",
  screen_intro:
    "色や大きさの見え方は、画面によって異なります。これから、お使いの画面の特性を確認します。" +
    "所要時間は約2分です。",
  screen_advice:
    "普段どおりの姿勢でお座りください。画面が黄色みを帯びる夜間モードは解除し、白がまぶしくない明るさに調整して、" +
    "照明や窓の光が画面に映り込まないようにしてください。",
  screen_step: "画面の確認 {n}/{all}",

  window_title: "ウィンドウが小さいようです",
  window_small:
    "この調査には、{wide} × {high} ピクセル以上のウィンドウが必要です。現在は {width} × {height} ピクセルです。" +
    "ウィンドウを広げるか、端末を横向きにするか、より大きな画面をお使いください。",
  window_now: "現在 {width} × {height} ピクセル",
  window_large: "十分な大きさになりました。",
  window_anyway: "このウィンドウで続ける",

  full_title: "全画面表示",
  full: "周りに何もない状態で画像をご覧いただくため、全画面表示にします。",
  full_leave: "Esc キーを押すと、いつでも元に戻せます。",
  full_enter: "全画面にする",
  full_without: "このまま続ける",

  card_title: "画面の大きさ",
  card:
    "銀行のカードなど、同じ大きさのカードを画面に当ててください。図の角をドラッグするか、スライダーまたは矢印キーを使って、" +
    "図をカードとぴったり同じ大きさにしてください。",
  card_upright: "カードは縦向きに当ててください。",
  card_slider: "図の大きさ",
  card_done: "カードと同じ大きさになりました",
  card_none: "カードが手元にありません",

  distance_title: "画面までの距離",
  distance:
    "右目を閉じるか、手で覆ってください。左目で四角形をじっと見つめてください。" +
    "四角形から左へ点が動いていき、あるところで見えなくなります。見えなくなった瞬間に、ボタンかスペースキーを押してください。",
  distance_try: "{n} 回目（全 {all} 回）",
  distance_start: "点を動かす",
  distance_gone: "見えなくなりました",
  distance_type: "距離を入力する",
  distance_typed: "目から画面までの距離を、測るか、およその値でお答えください。",
  distance_cm: "距離（センチメートル）",
  distance_range: "10から300までの数を入力してください。",
  distance_unknown: "わかりません",
  distance_missed: "点が端まで動きました。もう一度お試しください。",

  gamma_title: "中間の明るさ",
  gamma:
    "中央の円が周りの縞と同じ明るさに見えるように、スライダーを動かしてください。" +
    "目を細めるか、少し離れて縞をぼかすと、比べやすくなります。",
  gamma_slider: "円の明るさ",
  gamma_done: "同じ明るさに見えます",

  dark_title: "暗い部分",
  dark:
    "黒い背景に8個の四角形が並んでいます。暗くて見えないものもあります。" +
    "かろうじて見えるもののうち、最も暗いものを選んでください。",
  dark_patch: "{n} 番の四角形",
  dark_none: "どれも見えません",

  contrast_title: "わずかな濃淡",
  contrast:
    "切れ目のある輪が表示されます。輪は次第に薄くなります。切れ目の位置を、矢印キーかボタンでお答えください。" +
    "見えないときは、推測でお答えください。",
  no_medical: "これは医学的な検査ではありません。目の状態を診断するものではありません。",
  contrast_question: "切れ目はどこにありますか。",
  contrast_of: "輪 {n}/{all}",
  up: "上",
  down: "下",
  left: "左",
  right: "右",

  colour_title: "色の見え方",
  colour:
    "点でできた円が表示されます。色の違う点で数字が描かれているものがあります。見えた数字を、数字キーかボタンでお答えください。" +
    "見えないときは「見えません」を選んでください。",
  colour_question: "どの数字が見えますか。",
  colour_of: "円 {n}/{all}",
  colour_none: "見えません",

  instructions_title: "進め方",
  instructions_keys: "キー操作：左の画像は ←、右の画像は →",
  instructions_ties: "違いがわからないときは ↓ または =",
  instructions_training: "はじめに、練習が {n} 組あります。",
  instructions_begin: "練習を始める",
  training_over_title: "練習は終わりです",
  training_over: "ここからが本番です。全部で {n} 組あります。",
  resumed_title: "おかえりなさい",
  resumed: "これまでの回答は保存されています。{all} 組のうち {n} 組目から再開します。",

  left_picture: "左の画像",
  right_picture: "右の画像",
  tie: "違いがわからない",
  pair_of: "{n}/{all}",
  training_of: "練習 {n}/{all}",
  pair_keys: "← → キーでも選べます",
  pair_keys_tie: "← → キーでも選べます（違いがわからないときは ↓）",
  pair_early: "もう少しご覧になってからお答えください。",

  break_title: "休憩",
  break_next: "次の質問に移ります",
  break_text:
    "{all} 組のうち {n} 組が終わりました。遠くを見るなどして、しばらく目をお休めください。",
  stop: "中止したい",
  stop_title: "中止",
  stop_text:
    "いったん中断して、あとでこのブラウザーから再開することができます。参加を取りやめることもできます。その場合、あなたの回答は集計に含まれません。",
  stop_later: "あとで再開する",
  stop_withdraw: "参加を取りやめる",
  later_title: "中断しました",
  later: "回答は保存されています。再開するときは、このブラウザーで同じページを開いてください。",
  withdrawn_title: "参加を取りやめました",
  withdrawn:
    "あなたの回答は集計に含まれません。お時間をいただき、ありがとうございました。このページを閉じていただいて結構です。",

  offline: "接続が切れています。回答はこの端末に保存され、接続が戻り次第送信されます。",
  sending_title: "まもなく完了します",
  sending: "{n} 件の回答を送信しています。このページを開いたままお待ちください。",
  thanks_title: "ご協力ありがとうございました",
  thanks: "すべての回答が保存されました。このページを閉じていただいて結構です。",
  thanks_stored: "すべての回答が、無事に保存されました。",
  thanks_return: "元のサイトに戻る",
  thanks_return_use: "下のボタンを押してください。完了したことが、元のサイトに伝わります。",
  thanks_code: "次の完了コードを、お申し込みになったところでご入力ください。",
  thanks_code_too: "完了コードを尋ねられたときは、こちらをご入力ください。",
  thanks_next: "この端末で別の方が参加する",
  refused_title: "この画面では参加いただけません",
  refused:
    "ご協力ありがとうございます。申し訳ありませんが、この画面では、調査に必要な条件で画像を表示できません。" +
    "よろしければ、別の画面でお試しください。",
  refused_again: "画面をもう一度確認する",
  paused_title: "調査は一時休止中です",
  paused: "時間をおいて、もう一度お越しください。これまでの回答は保存されています。",
  closed_title: "調査は終了しました",
  closed: "ご関心をお寄せいただき、ありがとうございます。回答の受付は終了しました。",
  invited_title: "招待が必要です",
  invited: "お送りしたリンクを開いてください。リンクの末尾は # と長い文字列です。",
  unknown_title: "このリンクは使えません",
  unknown:
    "リンクが途中で切れているか、無効になった可能性があります。リンク全体を開き直すか、" +
    "リンクをお送りした担当者にお問い合わせください。",
  stopped_title: "この回は終了しました",
  stopped: "これ以上の回答は受け付けられません。担当者にお問い合わせください。",
  tabs_title: "すでに開いています",
  tabs: "この調査は、別のタブまたはウィンドウで開いています。そちらで続けるか、閉じてからこちらでもう一度お試しください。",
  broken_title: "問題が発生しました",
  broken:
    "これまでの回答は保存されています。ページを読み込み直してください。" +
    "それでも解決しない場合は、担当者にお知らせください。",
  unreachable: "サーバーに接続できません。自動的に再接続しています。",
};
