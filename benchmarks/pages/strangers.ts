/** Small words that one language has and the other has not: “die”, “in”, “was”, “not” are in both. */
const ownWords: { readonly [language: string]: readonly string[] } = {
  de: words(
    'der das und mit nicht ist sind ein eine einen einem einer du dir dich dein deine wie für auf aus bei vom zum zur von zu dem kein keine wenn dann nur auch noch oder aber wird kann soll wer wo wohin warum welche welcher welches ihr wir sie nach über unter vor',
  ),
  en: words(
    'the and with you your is are of to from for by this that these what which how why where who when then it its has have can does yet only or but should they we at on into there here',
  ),
}

/** Addresses, names with strokes, and what is spelt in capitals, as licences are. */
const notWords = /\S*[-/]\S*|\p{Lu}{2,}/gu

function words(line: string): readonly string[] {
  return line.split(' ')
}

/** Words of other languages in a text of this one. */
export function strangers(text: string, language: string): readonly string[] {
  const said = new Set(
    text
      .replace(notWords, ' ')
      .toLowerCase()
      .match(/\p{L}+/gu),
  )
  return Object.entries(ownWords)
    .filter(([other]) => other !== language)
    .flatMap(([, own]) => own.filter((word) => said.has(word)))
}
