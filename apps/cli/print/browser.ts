import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { findChromium, flags } from '@botgarten/chromium'
import type { Browser } from 'playwright-core'
import { FileError } from '../errors.ts'
import { say } from '../words.ts'

/** A folder for what the browser itself lays down: one that is stopped while it starts leaves things there. */
function folderForOnce(): string {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-browser-'))
  process.once('exit', () => rmSync(folder, { recursive: true, force: true, maxRetries: 3 }))
  return folder
}

/** The machine's browser, without a window. @throws FileError that says what to do where there is none */
export async function openBrowser(): Promise<Browser> {
  const executablePath = findChromium()
  if (executablePath === null) throw new FileError('file.noBrowser', { help: say('file.browserHelp') })
  // Asked for late: no other verb needs it.
  const { chromium } = await import('playwright-core')
  try {
    return await chromium.launch({
      executablePath,
      args: flags,
      env: { ...process.env, TMPDIR: folderForOnce() },
    })
  } catch (error) {
    const [said] = (error as Error).message.split('\n')
    throw new FileError('file.browserEnded', {
      ...{ path: executablePath, message: said ?? '' },
      help: say('file.browserHelp'),
    })
  }
}
