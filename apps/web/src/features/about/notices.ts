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

/** Complete texts of the licences: what each is for, and its file. */
export const licenceTexts = [
  ['Apache License 2.0', 'licences/Apache-2.0.txt'],
  ['Atkinson Hyperlegible Next: SIL OFL 1.1', 'licences/OFL-atkinson-hyperlegible-next.txt'],
  ['Baloo 2: SIL OFL 1.1', 'licences/OFL-baloo-2.txt'],
  ['Nunito: SIL OFL 1.1', 'licences/OFL-nunito.txt'],
  ['MIT, ISC, Blue Oak 1.0.0', 'licences/libraries.txt'],
] as const
