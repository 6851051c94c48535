/** What a teacher may set in `botgarten.txt` on the boot partition. */
export interface Settings {
  /** ISO 3166: whose rules the Wi-Fi follows. */
  readonly country: string
  /** Name of the hot spot, 1 to 32 bytes. */
  readonly hotspot: string
  /** WPA2: 8 to 63 printable ASCII letters; '': one is made. */
  readonly password: string
  readonly language: 'de' | 'en'
  readonly https: boolean
}

const usual: Settings = { country: 'DE', hotspot: 'Botgarten', password: '', language: 'de', https: false }

const lines = (text: string) =>
  text
    .replace(/^\uFEFF/, '')
    .split(/\r?\n/)
    .filter((line) => !/^\s*(#|$)/.test(line))

const fitsSsid = (name: string) => !/\p{Cc}/u.test(name) && Buffer.byteLength(name) <= 32 && name !== ''

/** Reads `key=value` a line; what is missing or cannot be used is as usual, so that the Pi starts in any case. */
export function readSettings(text: string): Settings {
  const given = new Map(
    lines(text).map((line) => {
      const [key = '', ...value] = line.split('=')
      return [key.trim(), value.join('=').trim()] as const
    }),
  )
  const take = (key: keyof Settings, fits: (value: string) => boolean) => {
    const value = given.get(key)
    return value !== undefined && fits(value) ? { [key]: value } : {}
  }
  return {
    ...usual,
    ...take('country', (value) => /^[A-Z]{2}$/.test(value)),
    ...take('hotspot', fitsSsid),
    ...take('password', (value) => /^[ -~]{8,63}$/.test(value)),
    ...take('language', (value) => value === 'de' || value === 'en'),
    https: given.get('https') === 'yes',
  }
}
