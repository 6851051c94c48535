import { findChromium, flags } from '@botgarten/chromium'
import type { Browser } from 'playwright-core'
import { FileError } from '../errors.ts'

const help = 'Install Chrome, Chromium or Edge, or say where one is: CHROMIUM=/path/to/chrome'

/** The machine's browser, without a window. @throws FileError that says what to do where there is none */
export async function openBrowser(): Promise<Browser> {
  const executablePath = findChromium()
  if (executablePath === null) throw new FileError(`No browser was found to print with. ${help}`)
  // Asked for late: no other verb needs it.
  const { chromium } = await import('playwright-core')
  try {
    return await chromium.launch({ executablePath, args: flags })
  } catch (error) {
    const [said] = (error as Error).message.split('\n')
    throw new FileError(`The browser ${executablePath} did not start (${said}). ${help}`)
  }
}
