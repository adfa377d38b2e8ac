// All words of the page. Names and notes of the user's files are shown as they are.
const english = {
  language: 'Language',
  loading: 'Loading …',
  noRun: 'No run is here: scene.js beside this page could not be read. Make it with “sabo view DIR”.',
  otherFormat: 'The files beside this page are of another version of sabo. Run “sabo view DIR” again.',
  noOther: 'The second run could not be read: {base}scene.js',
  noFrame: 'This frame could not be read and is shown empty: {file}',
  noGraphics: 'This browser shows no 3D graphics (WebGL 2).',
  picture: 'The flow in 3D. Drag to turn, scroll to come nearer, drag with the right button to move, click for values.',
  play: 'Play', pause: 'Pause', playOrPause: 'Play or pause (space)',
  time: 'Time', timeValue: '{time} s of {end} s',
  playSpeed: 'Speed of play', times: '{rate}×',
  earlier: 'One frame back (left arrow)', later: 'One frame on (right arrow)',
  colour: 'Colour by', depth: 'Depth', speed: 'Speed', pressure: 'Pressure',
  depthLong: 'vertical depth of the flow', speedLong: 'speed', pressureLong: 'pressure',
  exaggeration: 'Heights drawn', pointSize: 'Particles',
  show: 'Show', solids: 'Dams and buildings', lines: 'Sections, zones, path', labels: 'Names', contours: 'Contour lines',
  smooth: 'Fill in between frames',
  lookAt: 'Look at', all: 'whole flow',
  settings: 'Settings', reset: 'Whole view', above: 'From above', screenshot: 'Save picture',
  compare: 'Compare', first: 'First run', second: 'Second run', both: 'Side by side', swipe: 'Swipe', swipeAt: 'Edge at', swap: 'Press C to change',
  place: 'Place', elevation: 'Elevation', heightOver: 'Above ground', noFlow: 'no flow here', close: 'Close', values: 'Values', atTime: 'at {time} s',
  about: '{shown} particles{part}, {frames} frames · {program}',
  part: ' (one of {n})',
  between: 'between frames: filled in',
  clipped: 'Colours reach to 99.5 % of the particles of each frame; beyond, the darkest.',
};

const japanese = {
  language: '言語',
  loading: '読み込み中 …',
  noRun: '計算結果がありません。このページと同じ場所の scene.js を読めません。「sabo view フォルダ」で作成してください。',
  otherFormat: '別の版の sabo のファイルです。もう一度「sabo view フォルダ」を実行してください。',
  noOther: '二つ目の計算結果を読めません: {base}scene.js',
  noFrame: 'このコマを読めないため、空で表示します: {file}',
  noGraphics: 'このブラウザは3D表示(WebGL 2)に対応していません。',
  picture: '流れの3D表示。ドラッグで回転、スクロールで拡大、右ドラッグで移動、クリックで値を表示。',
  play: '再生', pause: '一時停止', playOrPause: '再生・一時停止(スペース)',
  time: '時刻', timeValue: '{time} s / {end} s',
  playSpeed: '再生速度', times: '{rate}倍',
  earlier: '前のコマ(←)', later: '次のコマ(→)',
  colour: '色分け', depth: '流動深', speed: '速さ', pressure: '圧力',
  depthLong: '流動深(鉛直)', speedLong: '速さ', pressureLong: '圧力',
  exaggeration: '高さの倍率', pointSize: '粒子の大きさ',
  show: '表示', solids: '堰堤・建物', lines: '測線・区域・流路', labels: '名称', contours: '等高線',
  smooth: 'コマの間を補間',
  lookAt: '注目', all: '流れ全体',
  settings: '設定', reset: '全体表示', above: '真上から', screenshot: '画像を保存',
  compare: '比較', first: '一つ目', second: '二つ目', both: '左右に並べる', swipe: 'スワイプ', swipeAt: '境界の位置', swap: 'Cキーで切替',
  place: '位置', elevation: '標高', heightOver: '地表からの高さ', noFlow: '流れなし', close: '閉じる', values: '値', atTime: '{time} s',
  about: '粒子 {shown}{part}、{frames} コマ · {program}',
  part: '({n}個に1個)',
  between: 'コマの間は補間',
  clipped: '色の範囲は各コマの粒子の99.5 %まで。それ以上は最も濃い色。',
};

const tables = { en: english, ja: japanese };
export const languages = { en: 'English', ja: '日本語' };

let current = english;

export function setLanguage(code) {
  current = tables[code] ?? english;
  document.documentElement.lang = code in tables ? code : 'en';
}

/** A text, its {names} replaced. */
export function text(key, values = {}) {
  return current[key].replace(/\{(\w+)\}/g, (_, name) => values[name]);
}
