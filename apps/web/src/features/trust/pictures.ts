import { line, pressed, row, step, type Step } from '#figures/steps/steps.ts'
import { m } from '#words/message.ts'

const own = 'Botgarten'
const file = 'botgarten.crt'

/** What is pressed on a system until it trusts the server, and how that is undone. */
export interface System {
  readonly name: string
  readonly steps: readonly Step[]
  readonly remove: string
}

export const systems = (): readonly System[] => [
  {
    name: 'Windows',
    remove: m['trust.removeWindows'](),
    steps: [
      step(m['trust.windows1'](), 'window', row('file', file), pressed('button', m['trust.label.install']())),
      step(
        m['trust.windows2'](),
        'window',
        line,
        row('option', m['trust.label.store']()),
        pressed('entry', m['trust.label.root']()),
      ),
      step(
        m['trust.windows3'](),
        'window',
        row('entry', own),
        line,
        pressed('button', m['trust.label.yes']()),
      ),
    ],
  },
  {
    name: 'iPadOS',
    remove: m['trust.removeIpad'](),
    steps: [
      step(
        m['trust.ipad1'](),
        'settings',
        pressed('entry', m['trust.label.profile']()),
        row('button', m['trust.label.installPlain']()),
      ),
      step(
        m['trust.ipad2'](),
        'settings',
        row('entry', m['trust.label.general']()),
        row('entry', m['trust.label.info']()),
        pressed('entry', m['trust.label.trustSettings']()),
      ),
      step(m['trust.ipad3'](), 'settings', line, pressed('switch', own)),
    ],
  },
  {
    name: 'Android',
    remove: m['trust.removeAndroid'](),
    steps: [
      step(
        m['trust.android1'](),
        'settings',
        row('entry', m['trust.label.credentials']()),
        row('entry', m['trust.label.installOne']()),
        pressed('entry', m['trust.label.ca']()),
      ),
      step(
        m['trust.android2'](),
        'settings',
        line,
        pressed('button', m['trust.label.anyway']()),
        row('file', file),
      ),
      step(m['trust.android3'](), 'settings', line, pressed('entry', m['trust.label.screenLock']())),
    ],
  },
  {
    name: 'ChromeOS',
    remove: m['trust.removeChrome'](),
    steps: [
      step(
        m['trust.chrome1'](),
        'browser',
        row('entry', 'chrome://certificate-manager'),
        pressed('entry', m['trust.label.byYou']()),
      ),
      step(m['trust.chrome2'](), 'browser', pressed('button', m['trust.label.import']()), row('file', file)),
      step(
        m['trust.chrome3'](),
        'browser',
        pressed('button', m['trust.label.import']()),
        row('device', ''),
        row('device', ''),
      ),
    ],
  },
  {
    name: 'macOS',
    remove: m['trust.removeMac'](),
    steps: [
      step(m['trust.mac1'](), 'window', row('file', file), pressed('entry', m['trust.label.login']())),
      step(m['trust.mac2'](), 'window', pressed('entry', own), row('entry', m['trust.label.trust']())),
      step(
        m['trust.mac3'](),
        'window',
        line,
        row('entry', 'SSL'),
        pressed('option', m['trust.label.always']()),
      ),
    ],
  },
]
