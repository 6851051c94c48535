/** Refusals that are about the new password, and are shown at its field. */
const ofNewPassword = new Set(['passwordCommon', 'passwordOfNames'])
/** The refusal that is shown at the field of the current password. */
const ofPassword = 'passwordWrong'

/** Which field of a form a refusal belongs to. */
export const fieldOf = (code: string | null): 'password' | 'newPassword' | null =>
  code === ofPassword ? 'password' : code !== null && ofNewPassword.has(code) ? 'newPassword' : null
