import * as v from 'valibot'

/** The shape of a password that is chosen. */
export const newPassword = v.pipe(v.string(), v.minLength(10), v.maxLength(128))

/** Why a password is refused: attackers try it first, or it is made of names that they know. */
export type Weakness = 'passwordCommon' | 'passwordOfNames'

/** The name of the program is on every page. */
const known = ['botgarten']
/** Letters that a password with one of the names needs in addition. */
const fewestLetters = 4
/** `aaaaaaaaaa`, `1212121212`. */
const fewestDifferent = 5
const shortestName = 3
/** Letters between digits that are compared with the list; keys in a row that count as a run. */
const [shortestWord, shortestRun] = [4, 5]
/** Rows of the keyboard and of the alphabet, to be run along in either direction. */
const rows = [
  ...['abcdefghijklmnopqrstuvwxyz', '0123456789012345678901234567890', '1234567890ß'],
  ...['qwertzuiopüasdfghjklöäyxcvbnm', 'qwertyuiopasdfghjklzxcvbnm', 'azertyuiopqsdfghjklmwxcvbn'],
]

let listed: Promise<ReadonlySet<string>> | undefined

/** Some 49,000 passwords of leaked lists. Loaded with the first password that is chosen. */
const commonPasswords = () =>
  (listed ??= import('@zxcvbn-ts/language-common').then(
    ({ dictionary }) => new Set(dictionary['passwords-common']),
  ))

const reversed = (text: string) => [...text].reverse().join('')
const isRun = (text: string) =>
  text.length >= shortestRun && rows.some((row) => row.includes(text) || reversed(row).includes(text))
const withoutEnds = (text: string) => text.replace(/^[^\p{L}]+/u, '').replace(/[^\p{L}]+$/u, '')
/** The repeated part of `passwortpasswort`; a text without repetition as it is. */
const unitOf = (text: string) => /^(.+?)\1+$/u.exec(text)?.[1] ?? text

function isOfNames(text: string, names: readonly string[]): boolean {
  const found = names.filter((name) => name.length >= shortestName && text.includes(name))
  const rest = found.reduce((left, name) => left.replaceAll(name, ''), text)
  return found.length > 0 && rest.replace(/[^\p{L}]/gu, '').length < fewestLetters
}

/**
 * Is a new password one that attackers try first? As NIST SP 800-63B, 5.1.1.2, asks: common passwords (with digits or punctuation
 * before or after, too), repetition, rows of keys, and names that go with the account. Capitals make no difference.
 * @param names username, and names of the teacher's classes
 * @returns null for a password that may be chosen
 */
export async function weaknessOf(password: string, names: readonly string[]): Promise<Weakness | null> {
  const text = password.normalize('NFKC').toLowerCase()
  if (isOfNames(text, [...known, ...names.map((name) => name.toLowerCase())])) return 'passwordOfNames'
  const unit = unitOf(text)
  const word = withoutEnds(unit)
  const listed = await commonPasswords()
  const isCommon =
    [text, unit].some((one) => listed.has(one)) || (word.length >= shortestWord && listed.has(word))
  const isMonotonous = new Set(unit).size < fewestDifferent || [unit, word].some(isRun)
  return isCommon || isMonotonous ? 'passwordCommon' : null
}
