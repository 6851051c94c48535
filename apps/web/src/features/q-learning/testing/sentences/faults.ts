/** Each fault of a sentence that a reader would notice, by name. */
const faults: { readonly [name: string]: (text: string, locale: string) => boolean } = {
  'a value of the code': (text) => /\b(NaN|undefined|null|Infinity)\b|\[object/.test(text),
  'a placeholder': (text) => /[{}]/.test(text),
  'a key': (text) => /(^|\s)[a-zA-Z]+\.[a-zA-Z.]+[a-zA-Z](\s|\.|$)/.test(text),
  'a hyphen as minus': (text) => /(^|[\s(])-\d/.test(text),
  'a decimal mark of another language': (text, locale) =>
    locale === 'de' ? /\d\.\d{1,2}(?!\d)/.test(text) : /\d,\d{1,2}(?!\d)/.test(text),
  'too many places': (text) => /\d[.,]\d{4,}/.test(text),
  'two spaces': (text) => / {2}/.test(text),
  'a space before a mark': (text) => /\s[.,;!?](\s|$)/.test(text),
  'a plural after one': (text, locale) =>
    locale === 'de'
      ? /(^|[^\d.,])1 (Versuche|Runden|Beispiele|Sekunden|Stellen|Räume|Abschnitte|Fahrten|Neuronen|Zeilen|Momente|Knöpfe|Gruppen|Farben|Wörter|Züge|Tore|Orte|Ecken|Mal[e]|Schritte)\b/.test(
          text,
        )
      : /(^|[^\d.,])1 (?!is\b|was\b|has\b|does\b|as\b|across\b|times as\b)[a-z]{3,}s\b(?<!ss)/.test(text),
}

/** Names of the faults of a sentence. */
export const faultsIn = (text: string, locale: string): readonly string[] =>
  Object.entries(faults).flatMap(([name, has]) => (has(text, locale) ? [name] : []))
