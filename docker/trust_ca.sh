# Sourced by the Dockerfile: has apt and npm trust the certificates in ca/ (a company's proxy that opens TLS), if there are any.
# apt may need them before it can install ca-certificates, so it is handed a file. The stage that is kept takes both away.
# shellcheck shell=sh
if ls /setup/ca/*.crt >/dev/null 2>&1; then
    cat /setup/ca/*.crt /etc/ssl/certs/ca-certificates.crt >/setup/ca.pem 2>/dev/null || true
    echo 'Acquire::https::CAInfo "/setup/ca.pem";' >/etc/apt/apt.conf.d/99-extra-ca
    export NODE_EXTRA_CA_CERTS=/setup/ca.pem
fi
