import words from './words.json' with { type: 'json' }

export type Word = keyof (typeof words)['de']
export type Language = keyof typeof words

/** A sentence for who looks at the screen. */
export const say = (language: Language, word: Word, facts: Record<string, string | number> = {}): string =>
  words[language][word].replaceAll(/\{(\w+)\}/g, (_, name: string) => String(facts[name]))

/** A code of letters, two for each module, as one of half the width and height: a screen has few lines. */
export function halved(code: string): string {
  const rows = code
    .split('\n')
    .filter((row) => row !== '')
    .map((row) => (row.match(/../gu) ?? []).map((module) => module.startsWith('█')))
  const pairs = rows.flatMap((row, at) => (at % 2 === 0 ? [[row, rows[at + 1] ?? []] as const] : []))
  return pairs
    .map(([upper, lower]) => upper.map((top, at) => ' ▄▀█'[(top ? 2 : 0) + (lower[at] ? 1 : 0)]).join(''))
    .join('\n')
}

export interface ScreenFacts {
  readonly language: Language
  readonly hotspot: { readonly name: string; readonly password: string }
  /** IPv4 addresses of the machine, that of its hot spot among them. */
  readonly addresses: readonly string[]
  /** Secret of the link for the first teacher; null: there is a teacher, or the lab has not started yet. */
  readonly token: string | null
  readonly started: boolean
  readonly passwordMade: boolean
  /** MB left for data. */
  readonly room: number
  readonly trial: 'kept' | 'failed' | null
}

/** Below these a teacher is told, MB. */
const [full, almostFull] = [20, 500]

/** By addresses alone, which every device understands, and by the name. */
const links = (addresses: readonly string[]) =>
  ['botgarten.local', ...addresses].map((host) => `http://${host}`)

/** @param own the address in the hot spot; where it is not sending, the first one */
export const teacherLink = (addresses: readonly string[], own: string, token: string): string =>
  `http://${addresses.includes(own) ? own : (addresses[0] ?? 'botgarten.local')}/teacher/start#${token}`

/** What stands on the screen, a block a thought; the code for the link comes last, drawn by `draw`. */
export function screenText(facts: ScreenFacts, own: string, draw: (link: string) => string): string {
  const { language, hotspot, addresses, token, room } = facts
  const word = (name: Word, given?: Record<string, string | number>) => say(language, name, given)
  const sends = addresses.includes(own)
  const link = token === null ? null : teacherLink(addresses, own, token)
  const blocks = [
    'Botgarten',
    sends ? word('wifi', { ...hotspot }) : word('noWifi'),
    word('addresses', { addresses: links(addresses).join('   ') }),
    sends && word('carries'),
    !facts.started && word('starting'),
    room < full ? word('full') : room < almostFull && word('almostFull', { room }),
    facts.trial && word(facts.trial),
    facts.passwordMade && word('password'),
    link !== null && `${word('teacher')}\n${link}`,
    link !== null && draw(link),
  ]
  return `${blocks.filter(Boolean).join('\n\n')}\n`
}
