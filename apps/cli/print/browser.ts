import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { findChromium, flags } from '@botgarten/chromium'
import type { Browser } from 'playwright-core'
import { FileError } from '../errors.ts'
import { message } from '../words.ts'

/** A folder for the files of the browser and of its library. It is deleted when this program ends. */
function folderForOnce(): string {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-browser-'))
  process.once('exit', () => rmSync(folder, { recursive: true, force: true, maxRetries: 3 }))
  return folder
}

/**
 * Ends this program at a signal while the browser is not started yet. From then on its library closes it at a signal; to exit at
 * once would remove the folder while the browser still writes into it.
 */
async function endingWell<Result>(act: () => Promise<Result>): Promise<Result> {
  const end = (signal: NodeJS.Signals) => {
    if (process.listenerCount(signal) === 0) process.exit(130)
  }
  for (const signal of signals) process.once(signal, end)
  try {
    return await act()
  } finally {
    for (const signal of signals) process.off(signal, end)
  }
}
const signals = ['SIGINT', 'SIGTERM'] as const

/** The machine's browser, without a window. @throws FileError that says what to do where there is none */
export async function openBrowser(): Promise<Browser> {
  const executablePath = findChromium()
  if (executablePath === null) throw new FileError('file.noBrowser', { help: message('file.browserHelp') })
  // Asked for late: no other verb needs it.
  const { chromium } = await import('playwright-core')
  try {
    return await endingWell(() => {
      process.env['TMPDIR'] = folderForOnce()
      return chromium.launch({ executablePath, args: flags })
    })
  } catch (error) {
    const [said] = (error as Error).message.split('\n')
    throw new FileError('file.browserEnded', {
      ...{ path: executablePath, message: said ?? '' },
      help: message('file.browserHelp'),
    })
  }
}
