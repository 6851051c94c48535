import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { findChromium, flags } from '@botgarten/chromium'
import type { Browser } from 'playwright-core'
import { FileError } from '../errors.ts'
import { message } from '../words.ts'

/** A folder for all that the browser and who starts it lay down: whenever this program ends, it goes. */
function folderForOnce(): string {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-browser-'))
  process.once('exit', () => rmSync(folder, { recursive: true, force: true, maxRetries: 3 }))
  return folder
}

/** Until the browser's own library listens, a signal ends this program as its end is meant: what lies about goes. */
async function endingWell<Result>(act: () => Promise<Result>): Promise<Result> {
  const end = () => process.exit(130)
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
