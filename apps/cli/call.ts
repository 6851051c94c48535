import { findCommand } from './commands.ts'
import { CallError, FileError } from './errors.ts'
import { helpOf, listOf } from './help.ts'
import { takeNotes } from './notes.ts'
import { languageIn, languageNamed, languagesNamed } from './options.ts'
import { languageOfMachine, message, speak, type Language } from './words.ts'

async function answerTo(args: readonly string[]): Promise<string> {
  const { lang, rest: words } = languageIn(args)
  const asked = lang === undefined ? [] : languagesNamed(lang)
  if (asked[0]) speak(asked[0])
  const { found, path, rest } = findCommand(words)
  const asksForHelp = rest.includes('--help') || rest.includes('-h')
  if (typeof found === 'function') {
    const command = await found()
    if (asked.length > 1 && !command.inLanguages) languageNamed(lang!)
    return asksForHelp ? helpOf(path, command) : command.execute(rest, asked)
  }
  if (asksForHelp) return listOf(path, found)
  const [name] = rest
  const names = Object.keys(found).join(', ')
  throw name === undefined
    ? new CallError('call.which', { names })
    : new CallError('call.unknownCommand', { name, names })
}

/** Where a call is at fault it is said where more stands. */
function sentenceOf(error: CallError | FileError, args: readonly string[]): string {
  const sentence = error.message.replaceAll('\n', ' ')
  if (error instanceof FileError) return sentence
  const { path } = findCommand(languageIn(args).rest)
  return message('call.help', { sentence, command: ['botgarten', ...path, '--help'].join(' ') })
}

/** Carries one call out. Exit 0: it ran · 1: a file is at fault · 2: the call is at fault. */
/** What a call gives back: its exit code, and what stands on standard output and standard error. */
export interface Answer {
  readonly status: 0 | 1 | 2
  readonly stdout: string
  readonly stderr: string
}

/**
 * Carries one call out. Status 0: it ran · 1: a file is at fault · 2: the call is at fault. `preset`: the language where
 * the call asks for none.
 */
export async function call(args: readonly string[], preset: Language = languageOfMachine()): Promise<Answer> {
  speak(preset)
  takeNotes()
  try {
    const stdout = `${await answerTo(args)}\n`
    return { status: 0, stdout, stderr: takeNotes() }
  } catch (error) {
    if (!(error instanceof CallError || error instanceof FileError)) throw error
    const stderr = `${takeNotes()}botgarten: ${sentenceOf(error, args)}\n`
    return { status: error instanceof CallError ? 2 : 1, stdout: '', stderr }
  }
}
