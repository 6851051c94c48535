import type { Command, Commands } from './commands.ts'
import { everywhere } from './options.ts'
import { languages, ownWord } from './words.ts'

const wordOf = (path: readonly string[], part: 'usage' | 'what') =>
  ownWord(`help.${path.length === 0 ? 'all' : path.join(' ')}.${part}`) ?? ''

const headOf = (path: readonly string[]) => `${wordOf(path, 'usage')}\n${wordOf(path, 'what')}`

/** What a command is for, and each of its options. */
export function helpOf(path: readonly string[], { options }: Pick<Command, 'options'>): string {
  const names = Object.keys({ ...options, ...everywhere })
  const lines = names.map((name) => [`--${name} ${valueOf(path, name)}`.trim(), ofOption(path, name, 'what')])
  return `${headOf(path)}\n\n${columns(lines)}`
}

/** What there is below a word: `botgarten --help`, `botgarten learn --help`. */
export function listOf(path: readonly string[], commands: Commands): string {
  const lines = Object.keys(commands).map((name) => [
    ['botgarten', ...path, name].join(' '),
    wordOf([...path, name], 'what'),
  ])
  return `${headOf(path)}\n\n${columns(lines)}`
}

/** What an option takes, as far as content/ decides it. */
const valueOf = (path: readonly string[], name: string) =>
  ofOption(path, name, 'value').replace('{languages}', languages.join('|'))

/** Some commands say more of an option, or something else, than all others. */
const ofOption = (path: readonly string[], name: string, part: 'value' | 'what') =>
  ownWord(`option.${path.join(' ')}.${name}.${part}`) ?? ownWord(`option.${name}.${part}`) ?? ''

function columns(lines: readonly (readonly string[])[]): string {
  const width = Math.max(...lines.map(([first]) => first!.length))
  return lines.map(([first, second]) => `  ${first!.padEnd(width)}  ${second}`).join('\n')
}
