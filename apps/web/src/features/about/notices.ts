import fontsAndMore from '../../../../../NOTICE?raw'
import librariesText from '../../../static/licences/libraries.txt?raw'

const linesOf = (text: string, heading: RegExp, end: RegExp) => {
  const lines = text.split('\n')
  const from = lines.findIndex((line) => heading.test(line)) + 1
  const rest = lines.slice(from)
  const length = rest.findIndex((line) => end.test(line))
  return rest.slice(0, length < 0 ? undefined : length)
}

/** The fonts of NOTICE, with whose they are. */
export const fonts: readonly string[] = linesOf(fontsAndMore, /^Fonts/, /^\s*SIL|^\S|^$/).map((line) =>
  line.trim().replace(/\s{2,}/g, ' '),
)

/** The libraries that are served: name, whose, licence. */
export const libraries: readonly (readonly [name: string, whose: string, licence: string])[] = linesOf(
  librariesText,
  /^$/,
  /^$/,
).map((line) => {
  const [name = '', whose = '', licence = ''] = line.split(/\s{2,}/)
  return [name, whose, licence]
})
