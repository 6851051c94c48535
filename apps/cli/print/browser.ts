import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { findChromium, flags } from '@botgarten/chromium'
import type { Browser } from 'playwright-core'
import { FileError } from '../errors.ts'

const help = 'Install Chrome, Chromium or Edge, or say where one is: CHROMIUM=/path/to/chrome'

/** A folder for what the browser itself lays down: one that is stopped while it starts leaves things there. */
function folderForOnce(): string {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-browser-'))
  process.once('exit', () => rmSync(folder, { recursive: true, force: true, maxRetries: 3 }))
  return folder
}

/** The machine's browser, without a window. @throws FileError that says what to do where there is none */
export async function openBrowser(): Promise<Browser> {
  const executablePath = findChromium()
  if (executablePath === null) throw new FileError(`No browser was found to print with. ${help}`)
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
    throw new FileError(`The browser ${executablePath} did not start (${said}). ${help}`)
  }
}
